#include "src/rig/drum/setup.hpp"

#include "demens/rig/programme/programme_run.hpp"
#include "demens/shape/packing.hpp"
#include "src/rig/rest.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig {

drum::Sampling::Sampling(Setup const& setup)
{
    double const steps = setup.sample_interval() / setup.time_step;
    looks = std::max<std::int64_t>(1, std::llround(steps * setup.expected_particles() / 3e6));
    steps_per_look = std::max<std::int64_t>(1, std::llround(steps / static_cast<double>(looks)));
    double const interval = static_cast<double>(looks * steps_per_look) * setup.time_step;
    turns = interval / setup.drum.seconds_per_turn();
    wanted = static_cast<std::size_t>(std::ceil(setup.measure_turns / turns));
}

namespace {

using drum::Ends;
using drum::Setup;

//! The lateral wall, then the ends.
std::vector<dem::Wall> walls(Setup const& setup)
{
    double const beyond = setup.grains.widest(); // no sphere meets an edge
    Vector3 const axis = {0, 1, 0};
    std::vector<dem::Wall> all = {{.shape = dem::Cylinder{.centre = {},
                                                          .axis = axis,
                                                          .half_length = 0.5 * setup.drum.width + beyond,
                                                          .radius = setup.drum.radius},
                                   .material = material_id(setup.model, setup.wall_material)}};
    if (setup.ends != Ends::periodic)
        for (double const side : {-0.5, 0.5})
            all.push_back({.shape = dem::Disc{.centre = {0, side * setup.drum.width, 0},
                                              .axis = axis,
                                              .radius = setup.drum.radius + beyond},
                           .material = material_id(setup.model, setup.end_material)});
    return all;
}

Apparatus build(Setup const& setup)
{
    double const beyond = 1.5 * setup.drum.radius, half = 0.5 * setup.drum.width;
    Apparatus apparatus{.model = setup.model, .options = simulation_options(setup.options, setup.time_step)};
    apparatus.options.skin = setup.skin;
    apparatus.options.gravity = setup.gravity();
    apparatus.options.domain_lower = {-beyond, -setup.drum.width, -beyond};
    apparatus.options.domain_upper = {beyond, setup.drum.width, beyond};
    if (setup.ends == Ends::periodic)
        apparatus.options.periodic.y = {-half, half};
    apparatus.walls = walls(setup);
    return apparatus;
}

double top_of_bed(Look& look, double bottom)
{
    double top = bottom;
    for (auto const& p : look.particles().places())
        top = std::max(top, p.z + p.radius);
    return top;
}

//! All grains, the last ones first to fall.
std::vector<grain::Grain> sample_of(Setup const& setup)
{
    RandomStream stream(derive_seed(setup.seed, 1));
    return setup.grains.sample_whole(setup.drum.mass, setup.density, stream);
}

//! As many of the next grains as fill a part of the free space so loosely that places are found at random.
std::vector<grain::Grain> next_batch(std::vector<grain::Grain> grains, double free_volume, double looseness)
{
    double const fraction = 0.22 * looseness;
    double volume = 0;
    std::vector<grain::Grain> batch;
    for (; !grains.empty(); grains.pop_back()) {
        double const d = grains.back().diameter;
        volume += std::numbers::pi / 6 * d * d * d;
        if (volume > fraction * free_volume)
            break;
        batch.push_back(grains.back());
    }
    return batch;
}

//! Drops as many of the next grains as there is room for above the bed.
void drop_batch(Bench& bench, Setup const& setup)
{
    auto left = sample_of(setup);
    left.resize(left.size() - bench.simulation.counts().particles);
    double const radius = setup.drum.radius, half_width = 0.5 * setup.drum.width;
    shape::Region const inside = shape::CylinderRegion{
        .from = {0, -half_width, 0}, .to = {0, half_width, 0}, .radius = radius, .inner_radius = 0};
    Look look(bench);
    double const level = top_of_bed(look, -radius);
    shape::FreeTest const above = [&](Vector3 const& p, double r) { return p.z - r >= level; };
    auto const batch = next_batch(left, shape::free_volume(inside, 0.5 * setup.grains.widest(), above),
                                  setup.grains.looseness());
    if (batch.empty())
        throw RunFailure(RunStatus::error,
                         fmt::format("{} of the grains found no room above the bed", left.size()));
    auto const places =
        shape::place_in_region(setup.grains.outlines(batch), inside, {}, above, bench.progress.random);
    bench.simulation.add(bodies_of(setup.grains, batch, places, material_id(setup.model, setup.material)));
}

void turn(Bench& bench, Setup const& setup)
{
    auto const turning = setup.ends == Ends::turning ? bench.simulation.walls().size() : 1;
    for (std::size_t k = 0; k < turning; ++k) {
        double const share = k == 0 ? 1.0 : setup.end_speed;
        bench.simulation.move(dem::WallId{static_cast<std::uint32_t>(k)},
                              dem::WallVelocity{.spin = {0, -share * setup.drum.angular_velocity, 0}});
    }
}

std::vector<Stage> stages(Setup const& setup, drum::Sampling const& sampling)
{
    // All spheres fall into the drum at rest, in as many batches as the room above the bed needs. At rest:
    // the mean particle could not rise by a thousandth of a diameter.
    Stage fill{.name = "fill",
               .waits_for = "the bed does not come to rest",
               .shortest = setup.fall_time(),
               .longest = 100 * setup.fall_time(),
               .landmark = "settled"};
    fill.enter = [&setup](Bench& bench) { drop_batch(bench, setup); };
    fill.until = [&setup, d = setup.grains.quantile(0.5)](Look& look) {
        return look.simulation().kinetic_energy() < 1e-3 * setup.drum.gravity * d * setup.drum.mass;
    };
    fill.repeats = [&setup](Look& look) {
        return look.simulation().counts().particles < sample_of(setup).size();
    };
    double const turn_time = setup.drum.seconds_per_turn();
    Stage discard{.name = "discard", .shortest = setup.discard_turns * turn_time};
    discard.enter = [&setup](Bench& bench) { turn(bench, setup); };
    Stage measure{.name = "measure",
                  .waits_for = "not all samples were taken",
                  .longest = 2 * setup.measure_turns * turn_time + sampling.turns * turn_time,
                  .looks_per_sample = sampling.looks,
                  .landmark = "final"};
    measure.until = [wanted = sampling.wanted](Look& look) { return look.progress().series.rows() > wanted; };
    std::vector<Stage> all = {fill};
    for (auto const& next : {rest_of(setup.options), {discard, measure}})
        all.insert(all.end(), next.begin(), next.end());
    return all;
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input); // kept alive by `build`
    drum::Sampling const sampling(*setup);
    Programme programme{.time_step = setup->time_step,
                        .steps_per_look = sampling.steps_per_look,
                        .expected_particles = setup->expected_particles(),
                        .work_per_particle = setup->grains.work_per_grain(),
                        .expected_duration = setup->expected_duration(),
                        .seed = derive_seed(setup->seed, 2),
                        .has_rigid_bodies = !setup->grains.are_spheres()};
    programme.check = [setup] { return size_warnings(setup->grains, setup->drum.mass, setup->density); };
    programme.build = [setup] { return build(*setup); };
    programme.names.walls = {"drum"};
    if (setup->ends != Ends::periodic)
        programme.names.walls.insert(programme.names.walls.end(), {"front", "back"});
    programme.stages = stages(*setup, sampling);
    auto const last = programme.stages.size() - 1;
    programme.readings = drum::readings(*setup);
    programme.profiles = drum::profiles(*setup, last);
    programme.responses = drum::responses(setup, last);
    if (setup->keeps_picture)
        programme.picture = observe::square_frame(setup->drum.radius, setup->pixels);
    return programme;
}

} // namespace

RigInfo drum_rig()
{
    RigInfo rig{
        .name = "drum",
        .doc = "rotating drum: energies of avalanches, and area, surface and angle of the bed's end view",
        .options = drum::options(),
        .responses = drum::response_infos()};
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
