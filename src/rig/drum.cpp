#include "demens/rig/drum.hpp"

#include "demens/observe/avalanches.hpp"
#include "demens/observe/end_view.hpp"
#include "demens/observe/potential_energy.hpp"
#include "demens/rig/common.hpp"
#include "demens/rig/stage.hpp"
#include "demens/shape/packing.hpp"
#include "demens/shape/sample_check.hpp"
#include "src/rig/drum_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig {
namespace {

using observe::Estimate;

//! Everything that is estimated from a run, in the order of the responses: each is followed by its standard
//! error.
struct Measured
{
    observe::AvalancheStatistics avalanches; //!< energies [mJ/kg], rate per turn
    Estimate energy, area, area_sd, r2, angle;

    std::vector<Estimate> all() const
    {
        return {avalanches.break_mean,
                avalanches.break_sd,
                avalanches.rest_mean,
                avalanches.rest_sd,
                avalanches.fall_mean,
                avalanches.fall_sd,
                avalanches.rate,
                energy,
                area,
                area_sd,
                r2,
                angle};
    }
};

std::vector<ResponseInfo> drum_responses()
{
    struct Quantity
    {
        std::string name, suffix, units, doc;
    };
    std::vector<ResponseInfo> responses;
    for (auto const& [name, suffix, units, doc] : std::vector<Quantity>{
             {"break_energy", "_mJ_kg", "mJ/kg", "specific potential energy before an avalanche, mean"},
             {"break_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation"},
             {"rest_energy", "_mJ_kg", "mJ/kg", "specific potential energy after an avalanche, mean"},
             {"rest_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation"},
             {"avalanche_energy", "_mJ_kg", "mJ/kg", "specific energy lost in an avalanche, mean"},
             {"avalanche_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation"},
             {"avalanches_per_turn", "", "1", "avalanches in a turn of the drum"},
             {"energy", "_mJ_kg", "mJ/kg", "specific potential energy, mean over time"},
             {"area", "_percent", "%", "part of the end view that particles cover, mean over time"},
             {"area_sd", "_percent", "%", "... standard deviation over time"},
             {"r2", "", "1", "straightness of the bed's surface in the end view, mean over time"},
             {"angle_of_repose", "_deg", "deg", "inclination of the bed's surface, mean over time"}}) {
        responses.push_back({name + suffix, units, doc});
        responses.push_back({name + "_se" + suffix, units, "... standard error of the value above"});
    }
    return responses;
}

dem::Periods periods(DrumSetup const& setup)
{
    double const half = 0.5 * setup.drum.width;
    return setup.ends == DrumEnds::periodic ? dem::Periods{.y = {-half, half}} : dem::Periods{};
}

void add_walls(dem::Simulation& simulation, DrumSetup const& setup)
{
    double const beyond = setup.sizes.largest(); // no sphere meets an edge
    Vector3 const axis = {0, 1, 0};
    simulation.add_wall({.shape = dem::Cylinder{.centre = {},
                                                .axis = axis,
                                                .half_length = 0.5 * setup.drum.width + beyond,
                                                .radius = setup.drum.radius},
                         .material = material_index(setup.model, setup.wall_material)});
    if (setup.ends == DrumEnds::periodic)
        return;
    for (double const side : {-0.5, 0.5})
        simulation.add_wall({.shape = dem::Disc{.centre = {0, side * setup.drum.width, 0},
                                                .axis = axis,
                                                .radius = setup.drum.radius + beyond},
                             .material = material_index(setup.model, setup.end_material)});
}

void set_turning(dem::Simulation& simulation, DrumSetup const& setup)
{
    std::size_t const turning = setup.ends == DrumEnds::turning ? simulation.walls().size() : 1;
    for (std::size_t k = 0; k < turning; ++k) {
        dem::Wall wall = simulation.walls()[k];
        wall.spin = {0, -setup.drum.angular_velocity, 0};
        simulation.set_wall(static_cast<std::uint32_t>(k), wall);
    }
}

double top_of_bed(dem::Simulation const& simulation, double bottom)
{
    double top = bottom;
    for (auto const& p : simulation.particles().place)
        top = std::max(top, p.z + p.radius);
    return top;
}

//! As many of the next spheres as fill a part of the free space so loosely that places are found at random.
std::vector<double> next_batch(std::vector<double>& diameters, double free_volume)
{
    double const fraction = 0.22;
    double volume = 0;
    std::vector<double> batch;
    while (!diameters.empty()) {
        double const d = diameters.back();
        volume += std::numbers::pi / 6 * d * d * d;
        if (volume > fraction * free_volume)
            break;
        batch.push_back(d);
        diameters.pop_back();
    }
    return batch;
}

//! Drops all spheres into the drum at rest, in as many batches as the room above the bed needs.
void fill(dem::Simulation& simulation, StageRunner& stages, DrumSetup const& setup, std::uint64_t seed)
{
    RandomStream size_stream(derive_seed(seed, 1)), place_stream(derive_seed(seed, 2));
    auto diameters = shape::sample_whole(setup.sizes, setup.drum.mass, setup.density, size_stream);
    auto const material = material_index(setup.model, setup.material);
    double const radius = setup.drum.radius, half_width = 0.5 * setup.drum.width;
    shape::Region const inside = shape::CylinderRegion{
        .from = {0, -half_width, 0}, .to = {0, half_width, 0}, .radius = radius, .inner_radius = 0};
    // At rest: the mean particle could not rise by a thousandth of a diameter.
    double const d = setup.sizes.quantile(0.5);
    auto const rests = [&] { return simulation.kinetic_energy() < 1e-3 * 9.81 * d * setup.drum.mass; };
    while (!diameters.empty()) {
        double const level = top_of_bed(simulation, -radius);
        shape::FreeTest const above = [&](Vector3 const& p, double r) { return p.z - r >= level; };
        auto const batch =
            next_batch(diameters, shape::free_volume(inside, 0.5 * setup.sizes.largest(), above));
        if (batch.empty())
            throw RunFailure(RunStatus::error,
                             fmt::format("{} of the spheres found no room above the bed", diameters.size()));
        auto const places = shape::fill_region(batch, inside, {}, above, place_stream);
        for (std::size_t k = 0; k < places.size(); ++k)
            simulation.add_particle(places[k], 0.5 * batch[k], material);
        stages.run_for("fill", setup.fall_time());
        stages.run_until("fill", 100 * setup.fall_time(), rests);
    }
}

//! Steps between looks at the run: a sample is taken every `checks` of them, so that neither a sample nor a
//! look at the health takes long to come.
struct Sampling
{
    Sampling(DrumSetup const& setup, double particles)
    {
        double const steps = setup.sample_interval() / setup.time_step;
        checks = std::max<std::int64_t>(1, std::llround(steps * particles / 3e6));
        steps_per_check = std::max<std::int64_t>(1, std::llround(steps / static_cast<double>(checks)));
    }
    double interval(double time_step) const
    {
        return static_cast<double>(checks * steps_per_check) * time_step;
    }
    std::int64_t checks, steps_per_check;
};

//! Columns of the series of a run, taken once a sample.
class Recorder
{
  public:
    Recorder(DrumSetup const& setup, Series& series)
        : setup_(setup), series_(series), view_(setup.drum.radius, setup.pixels)
    {
        series_ = {.names = {"time", "energy", "area", "angle", "r2"},
                   .units = {"s", "mJ/kg", "%", "deg", "1"},
                   .columns = std::vector<std::vector<double>>(5)};
    }

    void record(dem::Simulation const& simulation, double since)
    {
        auto const& particles = simulation.particles();
        view_.draw(particles);
        auto const surface = observe::fit_principal_line(view_.surface(setup_.sizes.quantile(0.5)));
        double const energy = observe::specific_potential_energy(particles, 9.81, -setup_.drum.radius);
        double const row[] = {simulation.time() - since, 1e3 * energy, 100 * view_.covered_fraction(),
                              surface.angle_deg, surface.r2};
        for (std::size_t k = 0; k < series_.columns.size(); ++k)
            series_.columns[k].push_back(row[k]);
    }

    std::size_t samples() const { return series_.columns.front().size(); }

  private:
    DrumSetup const& setup_;
    Series& series_;
    observe::EndView view_;
};

//! \param interval between samples [s]
Measured evaluate(Series const& series, DrumSetup const& setup, double interval)
{
    auto const &energy = series.columns[1], &area = series.columns[2];
    double const turns = interval / setup.drum.seconds_per_turn();
    return {.avalanches = observe::avalanche_statistics(energy, turns, 1e3 * setup.prominence),
            .energy = observe::mean_of(energy),
            .area = observe::mean_of(area),
            .area_sd = observe::standard_deviation_of(area),
            .r2 = observe::mean_of(series.columns[4]),
            .angle = observe::mean_of(series.columns[3])};
}

void measure(dem::Simulation& simulation, StageRunner& stages, DrumSetup const& setup,
             Sampling const& sampling, RunResult& result)
{
    Recorder recorder(setup, result.series);
    double const begin = simulation.time(), interval = sampling.interval(setup.time_step);
    double const turns = interval / setup.drum.seconds_per_turn();
    auto const wanted = static_cast<std::size_t>(std::ceil(setup.measure_turns / turns));
    std::int64_t check = 0;
    stages.run_until(
        "measure", 2 * setup.measure_turns * setup.drum.seconds_per_turn() + interval,
        [&] { return recorder.samples() > wanted; },
        [&] {
            if (check++ % sampling.checks == 0)
                recorder.record(simulation, begin);
        });
    result.responses.clear();
    for (auto const& estimate : evaluate(result.series, setup, interval).all()) {
        result.responses.push_back(estimate.value);
        result.responses.push_back(estimate.standard_error);
    }
}

double expected_particles(DrumSetup const& setup)
{
    return setup.drum.mass / setup.density * setup.sizes.spheres_per_volume();
}

void run(RunInput const& input, RunHooks const& hooks, RunResult& result)
{
    DrumSetup const setup(input);
    double const beyond = 1.5 * setup.drum.radius;
    dem::Simulation simulation(setup.model,
                               with_energy_options({.time_step = setup.time_step,
                                                    .skin = setup.skin,
                                                    .domain_lower = {-beyond, -setup.drum.width, -beyond},
                                                    .domain_upper = {beyond, setup.drum.width, beyond},
                                                    .periodic = periods(setup),
                                                    .team = hooks.team},
                                                   input.experiment));
    add_walls(simulation, setup);
    Sampling const sampling(setup, expected_particles(setup));
    StageRunner stages(simulation, hooks, static_cast<double>(sampling.steps_per_check) * setup.time_step);
    auto const finish = [&] {
        result.particles = static_cast<std::int64_t>(simulation.particles().size());
        record_end(simulation, result);
    };
    try {
        fill(simulation, stages, setup, input.seed);
        result.snapshots.push_back(take_snapshot(simulation, "settled"));
        set_turning(simulation, setup);
        stages.run_for("discard", setup.discard_turns * setup.drum.seconds_per_turn());
        measure(simulation, stages, setup, sampling, result);
        result.snapshots.push_back(take_snapshot(simulation, "final"));
    } catch (...) {
        finish();
        throw;
    }
    finish();
}

double predict_cost(RunInput const& input)
{
    DrumSetup const setup(input);
    double const turning = (setup.discard_turns + setup.measure_turns) * setup.drum.seconds_per_turn();
    return expected_particles(setup) * (5 * setup.fall_time() + turning) / setup.time_step;
}

} // namespace

RigInfo drum_rig()
{
    return {.name = "drum",
            .doc = "rotating drum: energies of avalanches, and area, surface and angle of the bed's end view",
            .options = drum_options(),
            .responses = drum_responses(),
            .check = [](RunInput const& input) { check_drum(DrumSetup(input)); },
            .warnings =
                [](RunInput const& input) {
                    DrumSetup const setup(input);
                    return size_warnings(setup.sizes, setup.drum.mass, setup.density);
                },
            .predict_cost = predict_cost,
            .run =
                [](RunInput const& input, RunHooks const& hooks) {
                    return run_guarded(drum_responses().size(),
                                       [&](RunResult& result) { run(input, hooks, result); });
                }};
}

} // namespace demens::rig
