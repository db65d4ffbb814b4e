#include "src/rig/drawdown/setup.hpp"

#include "demens/rig/programme/programme_run.hpp"
#include "demens/shape/packing.hpp"
#include "src/rig/rest.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace demens::rig {
namespace {

using drawdown::Setup;

constexpr double least_filling_friction = 0.01; //!< to which it is lowered for a bed that lies too high [-]

//! Numbers of the gate's halves, in the order in which `walls` gives them.
enum GateHalf : std::uint32_t
{
    gate_left = 9,
    gate_right
};

std::vector<dem::Wall> walls(Setup const& rig, double top)
{
    dem::MaterialId const wood = material_id(rig.model, rig.wood), glass = material_id(rig.model, rig.glass);
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
    auto const window = [&](double y) {
        return dem::Wall{.shape = dem::Rectangle{.centre = {0, y, 0.5 * (top - rig.drop)},
                                                 .axis_u = {0, 0, 1},
                                                 .axis_v = {1, 0, 0},
                                                 .half_u = 0.5 * (top + rig.drop) + beyond,
                                                 .half_v = widest},
                         .material = glass};
    };
    // The gate slides in two halves just below the floor.
    double const gate_z = -0.05 * rig.grains.smallest_ball();
    return {window(-0.5 * rig.depth),
            window(0.5 * rig.depth),
            floor(-half - beyond, -half_slot, 0),
            floor(half_slot, half + beyond, 0),
            side(-half, 0, top),
            side(half, 0, top),
            floor(-widest, widest, -rig.drop),
            side(-half_lower, -rig.drop, 0),
            side(half_lower, -rig.drop, 0),
            floor(-half_slot - beyond, 0, gate_z),
            floor(0, half_slot + beyond, gate_z)};
}

//! In the order of the walls.
std::vector<std::string> wall_names()
{
    return {"front",       "back",       "upper_floor_left", "upper_floor_right", "upper_left", "upper_right",
            "lower_floor", "lower_left", "lower_right",      "gate_left",         "gate_right"};
}

//! The spheres lie loosely in the upper box, as high as they need, and will rain down.
Apparatus build(Setup const& rig)
{
    RandomStream size_stream(derive_seed(rig.seed, 1)), place_stream(derive_seed(rig.seed, 2));
    auto const sample = rig.grains.sample_whole(rig.mass, rig.density, size_stream);
    auto const places =
        shape::place_loosely(rig.grains.outlines(sample), {-0.5 * rig.width, -0.5 * rig.depth, 1e-4},
                             rig.width, rig.depth, 0.28 * rig.grains.looseness(), place_stream);
    double top = 0;
    for (auto const& place : places)
        top = std::max(top, place.centre.z + rig.grains.widest());
    double const beyond = std::max(rig.width, rig.lower_width);
    Apparatus apparatus{.model = rig.model, .options = simulation_options(rig.options, rig.time_step)};
    apparatus.options.skin = rig.skin;
    apparatus.options.domain_lower = {-beyond, -rig.depth, -rig.drop - 0.1};
    apparatus.options.domain_upper = {beyond, rig.depth, top + 1};
    apparatus.bodies = bodies_of(rig.grains, sample, places, material_id(rig.model, rig.material));
    apparatus.walls = walls(rig, top);
    return apparatus;
}

//! The mean particle could not rise by a thousandth of a diameter.
bool rests(Look& look, Setup const& rig)
{
    auto& simulation = look.simulation();
    double const particles = static_cast<double>(simulation.counts().particles);
    double const at_rest = rig.mass / particles * rig.gravity * 1e-3 * rig.grains.quantile(0.5);
    return simulation.kinetic_energy() / particles < at_rest;
}

//! Rain and rest. A bed that lies higher than its bulk density asks for has its friction lowered, step by
//! step, until it has sunk to its height; nothing presses on it, since a pressure that stays between the
//! sides makes an arch over the slot.
std::vector<Stage> filling(Setup const& rig)
{
    auto const at_rest = [&](std::string name, double shortest, double longest) {
        return Stage{.name = std::move(name),
                     .until = [&rig](Look& look) { return rests(look, rig); },
                     .waits_for = "the bed does not come to rest",
                     .shortest = shortest,
                     .longest = longest};
    };
    auto fill = at_rest("fill", 0.1, 20);
    fill.model = rig.with_friction_up_to(rig.filling_friction);
    std::vector<Stage> stages = {fill};
    auto const is_too_high = [&rig](Look& look) {
        return drawdown::bed_height(look, rig) > rig.bed_height();
    };
    for (double friction = 0.7 * std::min(rig.filling_friction, rig.largest_friction());
         friction > least_filling_friction; friction *= 0.7) {
        auto sink = at_rest("sink", 0.02, 5);
        sink.model = rig.with_friction_up_to(friction);
        sink.needed = is_too_high;
        sink.until = [is_too_high, &rig](Look& look) { return !is_too_high(look) || rests(look, rig); };
        stages.push_back(std::move(sink));
    }
    // Twice, with the coefficients set twice: beds that were loose before keep their bits so.
    for (double const shortest : {0.05, 0.02}) {
        stages.push_back(at_rest("settle", shortest, 5));
        stages.back().model = rig.model;
    }
    stages.back().landmark = "settled";
    return stages;
}

//! Grains over the middle half of the slot are held by an arch: wedges end at its edges.
bool is_slot_covered(Look& look, Setup const& rig)
{
    auto const places = look.grains().places();
    return std::any_of(places.begin(), places.end(),
                       [&](dem::Place const& p) { return p.z > 0 && std::abs(p.x) < 0.25 * rig.slot; });
}

//! Whether the discharge is over: nothing moves, enough has left, and nothing lies over the slot.
//! \throws RunFailure when nothing moves for half a second though it is not.
bool has_ended(Look& look, Setup const& rig)
{
    auto const& progress = look.progress();
    auto const &times = progress.series.column("time"), &masses = progress.series.column("upper_mass"),
               &speeds = progress.series.column("largest_speed");
    if (speeds.back() >= rig.end_speed)
        return false;
    if (masses.back() < rig.end_fraction * masses.front() && !is_slot_covered(look, rig))
        return true;
    std::size_t quiet = speeds.size() - 1;
    while (quiet > progress.rows[progress.stage].first && speeds[quiet - 1] < rig.end_speed)
        --quiet;
    if (times.back() - times[quiet] > 0.5)
        throw RunFailure(RunStatus::timed_out,
                         fmt::format("an arch blocks the slot: nothing moves, and {:.3g} of {:.3g} kg are "
                                     "still in the upper box",
                                     masses.back(), masses.front()));
    return false;
}

//! The gate slides open, or is gone at once.
std::vector<Stage> discharge(Setup const& rig)
{
    auto const move_gate = [](Bench& bench, double speed, bool is_there) {
        for (auto const& [half, direction] : {std::pair{gate_left, -1.0}, std::pair{gate_right, 1.0}}) {
            bench.simulation.move(dem::WallId{half},
                                  dem::WallVelocity{.velocity = {direction * speed, 0, 0}});
            bench.simulation.activate(dem::WallId{half}, is_there);
        }
    };
    double const opening = rig.gate_speed > 0 ? 0.5 * rig.slot / rig.gate_speed : 0.0;
    Stage open{.name = "open", .shortest = opening, .looks_per_sample = 1};
    open.enter = [&rig, move_gate](Bench& bench) { move_gate(bench, rig.gate_speed, true); };
    open.needed = [&rig](Look&) { return rig.gate_speed > 0; };
    Stage discharge{.name = "discharge", .looks_per_sample = 1, .landmark = "final"};
    discharge.enter = [move_gate](Bench& bench) { move_gate(bench, 0, false); };
    discharge.until = [&rig](Look& look) { return has_ended(look, rig); };
    discharge.waits_for = "particles still move";
    discharge.longest = rig.longest;
    return {open, discharge};
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input);
    auto const& rig = *setup; // kept alive by `build`
    Programme programme{.time_step = rig.time_step,
                        .steps_per_look =
                            std::max<std::int64_t>(1, std::llround(rig.interval / rig.time_step)),
                        .expected_particles = rig.expected_particles(),
                        .work_per_particle = rig.grains.work_per_grain(),
                        .expected_duration = rig.expected_duration(),
                        .has_rigid_bodies = !rig.grains.are_spheres()};
    programme.check = [setup] { return size_warnings(setup->grains, setup->mass, setup->density); };
    programme.build = [setup] { return build(*setup); };
    programme.names.walls = wall_names();
    programme.stages = filling(rig);
    auto const settled = programme.stages.size() - 1;
    for (auto const& next : {rest_of(rig.options), discharge(rig)})
        programme.stages.insert(programme.stages.end(), next.begin(), next.end());
    auto const last = programme.stages.size() - 1;
    programme.readings = drawdown::readings();
    programme.profiles = drawdown::profiles(rig, settled, last);
    for (auto const& measure : drawdown::measures())
        programme.responses.push_back(
            {measure.info, last, "there are too few points for its line",
             [measure, setup](Progress const& p) { return measure.reduce(p, *setup); }});
    return programme;
}

} // namespace

RigInfo drawdown_rig()
{
    RigInfo rig{.name = "drawdown",
                .doc = "Draw Down Test: a box empties through a slot into a box below (Roessler et al. 2019)",
                .options = drawdown::options()};
    for (auto const& measure : drawdown::measures())
        rig.responses.push_back(measure.info);
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
