#include "demens/rig/drawdown.hpp"

#include "demens/observe/surface.hpp"
#include "demens/rig/common.hpp"
#include "demens/rig/stage.hpp"
#include "demens/shape/packing.hpp"
#include "demens/shape/sample_check.hpp"
#include "src/rig/drawdown_setup.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace demens::rig {
namespace {

//! Walls that are moved or removed while the rig works.
struct MovingWalls
{
    std::uint32_t gate_left, gate_right, lid;
};

MovingWalls add_walls(dem::Simulation& simulation, DrawdownSetup const& rig, double top)
{
    std::uint32_t const wood = material_index(rig.model, rig.wood),
                        glass = material_index(rig.model, rig.glass);
    double const beyond = 0.05; // floors reach past the sides, so that no sphere meets an edge there
    double const half_depth = 0.5 * rig.depth + beyond;
    auto const floor = [&](double from_x, double to_x, double z) {
        return dem::Wall{.shape = dem::Rectangle{.centre = {0.5 * (from_x + to_x), 0, z},
                                                 .axis_u = {1, 0, 0},
                                                 .axis_v = {0, 1, 0},
                                                 .half_u = 0.5 * (to_x - from_x),
                                                 .half_v = half_depth},
                         .material = wood};
    };
    auto const side = [&](double x, double from_z, double to_z) {
        return dem::Wall{.shape = dem::Rectangle{.centre = {x, 0, 0.5 * (from_z + to_z)},
                                                 .axis_u = {0, 1, 0},
                                                 .axis_v = {0, 0, 1},
                                                 .half_u = half_depth,
                                                 .half_v = 0.5 * (to_z - from_z)},
                         .material = wood};
    };
    double const half = 0.5 * rig.width, half_slot = 0.5 * rig.slot, half_lower = 0.5 * rig.lower_width;
    double const widest = std::max(half, half_lower) + beyond;
    for (double const y : {-0.5 * rig.depth, 0.5 * rig.depth})
        simulation.add_wall({.shape = dem::Rectangle{.centre = {0, y, 0.5 * (top - rig.drop)},
                                                     .axis_u = {0, 0, 1},
                                                     .axis_v = {1, 0, 0},
                                                     .half_u = 0.5 * (top + rig.drop) + beyond,
                                                     .half_v = widest},
                             .material = glass});
    simulation.add_wall(floor(-half - beyond, -half_slot, 0));
    simulation.add_wall(floor(half_slot, half + beyond, 0));
    simulation.add_wall(side(-half, 0, top));
    simulation.add_wall(side(half, 0, top));
    simulation.add_wall(floor(-widest, widest, -rig.drop));
    simulation.add_wall(side(-half_lower, -rig.drop, 0));
    simulation.add_wall(side(half_lower, -rig.drop, 0));
    // The gate slides in two halves just below the floor.
    double const gate_z = -0.05 * rig.sizes.smallest();
    MovingWalls moving{};
    moving.gate_left = simulation.add_wall(floor(-half_slot - beyond, 0, gate_z));
    moving.gate_right = simulation.add_wall(floor(0, half_slot + beyond, gate_z));
    dem::Wall lid = floor(-half, half, top);
    lid.active = false;
    moving.lid = simulation.add_wall(lid);
    return moving;
}

double highest(dem::Simulation const& simulation)
{
    double z = -std::numeric_limits<double>::infinity();
    for (auto const& p : simulation.particles().place)
        z = std::max(z, p.z + p.radius);
    return z;
}

double mass_above(dem::Simulation const& simulation, double z)
{
    double mass = 0;
    for (std::size_t k = 0; k < simulation.particles().size(); ++k)
        if (simulation.particles().place[k].z > z)
            mass += simulation.particles().motion[k].mass;
    return mass;
}

double mean_kinetic_energy(dem::Simulation const& simulation)
{
    return simulation.kinetic_energy() / static_cast<double>(simulation.particles().size());
}

//! Rain, rest, and a lid that levels the bed to its height.
void fill(dem::Simulation& simulation, StageRunner& stages, DrawdownSetup const& rig,
          MovingWalls const& moving)
{
    simulation.set_model(rig.filling_model);
    // At rest: the mean particle could not rise by a thousandth of a diameter.
    double const d = rig.sizes.quantile(0.5);
    double const particle_mass = rig.mass / static_cast<double>(simulation.particles().size());
    double const at_rest = particle_mass * 9.81 * 1e-3 * d;
    auto const rests = [&] { return mean_kinetic_energy(simulation) < at_rest; };
    stages.run_for("fill", 0.1);
    stages.run_until("fill", 20, rests);

    double const level = rig.bed_height();
    double const top = highest(simulation);
    if (top > level) {
        dem::Wall lid = simulation.walls()[moving.lid];
        double const duration = 0.1;
        auto& plate = std::get<dem::Rectangle>(lid.shape);
        plate.centre.z = top;
        lid.velocity = {0, 0, -(top - level) / duration};
        lid.active = true;
        simulation.set_wall(moving.lid, lid);
        stages.run_for("level", duration);
        plate.centre.z = level;
        lid.velocity = {};
        simulation.set_wall(moving.lid, lid);
        stages.run_until("level", 5, rests);
    }
    // Without the lid the bed relaxes while friction is still low; else it would keep the lid's pressure
    // between the sides and arch over the slot.
    dem::Wall lid = simulation.walls()[moving.lid];
    lid.active = false;
    simulation.set_wall(moving.lid, lid);
    stages.run_for("settle", 0.05);
    stages.run_until("settle", 5, rests);
    simulation.set_model(rig.model);
    stages.run_for("settle", 0.02);
    stages.run_until("settle", 5, rests);
}

void set_gate(dem::Simulation& simulation, MovingWalls const& moving, double speed, bool active)
{
    for (auto const& [number, direction] :
         {std::pair{moving.gate_left, -1.0}, std::pair{moving.gate_right, 1.0}}) {
        dem::Wall half = simulation.walls()[number];
        half.velocity = {direction * speed, 0, 0};
        half.active = active;
        simulation.set_wall(number, half);
    }
}

//! Mean angle of the two slopes that fall away from the middle (`falls_outwards`) or towards it [deg].
double slope_angle(observe::SurfaceProfile const& profile, double inner, double outer, double margin,
                   bool falls_outwards)
{
    double const skip = margin * (outer - inner);
    auto const left = observe::fit_line(profile, -outer + skip, -inner - skip);
    auto const right = observe::fit_line(profile, inner + skip, outer - skip);
    if (left.points < 3 || right.points < 3)
        return std::numeric_limits<double>::quiet_NaN();
    double const sign = falls_outwards ? -1 : 1;
    return 0.5 * sign * (right.angle_deg() - left.angle_deg());
}

//! Slope of the linear part of the mass curve, from 10 to 60 % of what will leave: before it the flow builds
//! up, after it only the wedges feed the slot [kg/s].
double mass_flow(std::vector<double> const& time, std::vector<double> const& mass)
{
    double const full = mass.front(), leaving = mass.front() - mass.back();
    std::vector<double> t, m;
    for (std::size_t k = 0; k < time.size(); ++k)
        if (mass[k] < full - 0.1 * leaving && mass[k] > full - 0.6 * leaving) {
            t.push_back(time[k]);
            m.push_back(mass[k]);
        }
    if (t.size() < 3)
        return std::numeric_limits<double>::quiet_NaN();
    return -observe::fit_line(t, m).slope;
}

void run(RunInput const& input, RunHooks const& hooks, RunResult& result)
{
    DrawdownSetup const rig(input);
    RandomStream size_stream(derive_seed(input.seed, 1)), place_stream(derive_seed(input.seed, 2));
    auto const diameters = shape::sample_whole(rig.sizes, rig.mass, rig.density, size_stream);
    result.particles = static_cast<std::int64_t>(diameters.size());
    auto const places = shape::loose_packing(diameters, {-0.5 * rig.width, -0.5 * rig.depth, 1e-4}, rig.width,
                                             rig.depth, 0.28, place_stream);
    double top = 0;
    for (Vector3 const& p : places)
        top = std::max(top, p.z + rig.sizes.largest());

    double const beyond = std::max(rig.width, rig.lower_width);
    dem::Simulation simulation(rig.model,
                               with_energy_options({.time_step = rig.time_step,
                                                    .skin = rig.skin,
                                                    .domain_lower = {-beyond, -rig.depth, -rig.drop - 0.1},
                                                    .domain_upper = {beyond, rig.depth, top + 1},
                                                    .team = hooks.team},
                                                   input.experiment));
    std::uint32_t const material = material_index(rig.model, rig.material);
    for (std::size_t k = 0; k < places.size(); ++k)
        simulation.add_particle(places[k], 0.5 * diameters[k], material);
    MovingWalls const moving = add_walls(simulation, rig, top);
    StageRunner stages(simulation, hooks, rig.interval);

    result.series = {.names = {"time", "upper_mass", "largest_speed"},
                     .units = {"s", "kg", "m/s"},
                     .columns = {{}, {}, {}}};
    double opened = 0;
    try {
        fill(simulation, stages, rig, moving);
        result.snapshots.push_back(take_snapshot(simulation, "settled"));
        auto const bed = observe::surface_profile(simulation.particles(), -0.5 * rig.width, 0.5 * rig.width,
                                                  200, 0, [](dem::Place const& p) { return p.z > 0; });
        double bed_height = 0;
        for (double const z : bed.z)
            bed_height += z / static_cast<double>(bed.z.size());
        double const total = mass_above(simulation, 0);

        opened = simulation.time();
        auto const observe = [&] {
            result.series.columns[0].push_back(simulation.time() - opened);
            result.series.columns[1].push_back(mass_above(simulation, 0));
            result.series.columns[2].push_back(simulation.largest_speed());
        };
        auto const& masses = result.series.columns[1];
        auto const& speeds = result.series.columns[2];
        double quiet_since = std::numeric_limits<double>::infinity();
        set_gate(simulation, moving, rig.gate_speed, true);
        stages.run_for("open", 0.5 * rig.slot / rig.gate_speed, observe);
        set_gate(simulation, moving, 0, false);
        stages.run_until(
            "discharge", rig.longest,
            [&] {
                if (speeds.back() >= rig.end_speed) {
                    quiet_since = std::numeric_limits<double>::infinity();
                    return false;
                }
                if (masses.back() < rig.end_fraction * total)
                    return true;
                quiet_since = std::min(quiet_since, simulation.time());
                if (simulation.time() - quiet_since > 0.5)
                    throw RunFailure(
                        RunStatus::timed_out,
                        fmt::format("an arch blocks the slot: nothing moves, and {:.3g} of {:.3g} kg are "
                                    "still in the upper box",
                                    masses.back(), total));
                return false;
            },
            observe);
        result.snapshots.push_back(take_snapshot(simulation, "final"));

        auto const heap =
            observe::surface_profile(simulation.particles(), -0.5 * rig.lower_width, 0.5 * rig.lower_width,
                                     400, -rig.drop, [](dem::Place const& p) { return p.z < 0; });
        auto const wedges =
            observe::surface_profile(simulation.particles(), -0.5 * rig.width, 0.5 * rig.width, 400, 0,
                                     [](dem::Place const& p) { return p.z > 0; });
        result.responses = {slope_angle(heap, 0, 0.5 * rig.lower_width, rig.wedge_margin, true),
                            slope_angle(wedges, 0.5 * rig.slot, 0.5 * rig.width, rig.wedge_margin, false),
                            mass_flow(result.series.columns[0], masses),
                            masses.back(),
                            rig.mass / (bed_height * rig.width * rig.depth),
                            simulation.time() - opened};
    } catch (...) {
        record_end(simulation, result);
        throw;
    }
    record_end(simulation, result);
}

} // namespace

RigInfo drawdown_rig()
{
    return {
        .name = "drawdown",
        .doc = "Draw Down Test: a box empties through a slot into a box below (Roessler et al. 2019)",
        .options = drawdown_options(),
        .responses = {{"angle_of_repose_deg", "deg",
                       "slope of the heap in the lower box, mean of both sides"},
                      {"shear_angle_deg", "deg", "slope of the wedges left in the upper box, mean of both"},
                      {"mass_flow_kg_s", "kg/s", "slope of the linear part of the mass curve"},
                      {"final_mass_kg", "kg", "mass left in the upper box"},
                      {"bulk_density_kg_m3", "kg/m^3", "of the levelled bed, before the gate opens"},
                      {"discharge_time_s", "s", "from the opening of the gate to the end of the run"}},
        .check = [](RunInput const& input) { check_drawdown(DrawdownSetup(input)); },
        .warnings =
            [](RunInput const& input) {
                DrawdownSetup const rig(input);
                return size_warnings(rig.sizes, rig.mass, rig.density);
            },
        .predict_cost = [](RunInput const& input) { return drawdown_cost(DrawdownSetup(input)); },
        .run =
            [](RunInput const& input, RunHooks const& hooks) {
                return run_guarded(6, [&](RunResult& result) { run(input, hooks, result); });
            }};
}

} // namespace demens::rig
