// Static angle of repose: a cylinder that is lifted, or a funnel, pours a heap on a plate.
#include "src/rig/heap/setup.hpp"

#include "demens/rig/programme/programme_run.hpp"
#include "demens/shape/packing.hpp"
#include "src/rig/rest.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace demens::rig {
namespace {

using heap::Feed;
using heap::Setup;

enum Walls : std::uint32_t
{
    plate,
    below,
    vessel, //!< the cylinder; above a funnel what is filled in stands in one, too
    gate,   //!< of the funnel; the cylinder has none
};

std::vector<dem::Wall> walls(Setup const& rig)
{
    auto const of_vessel = material_id(rig.model, rig.wall_material),
               of_plate = material_id(rig.model, rig.plate_material);
    double const reach = rig.furthest(), bottom = rig.bottom_of_fill(),
                 top = rig.top_of_fill() + rig.grains.widest();
    Vector3 const up = {0, 0, 1};
    std::vector<dem::Wall> all;
    auto const add = [&](dem::WallShape const& shape, dem::MaterialId material) {
        all.push_back({.shape = shape, .material = material});
    };
    if (rig.plate_radius > 0)
        add(dem::Disc{{}, up, rig.plate_radius}, of_plate);
    else
        add(dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, reach, reach}, of_plate);
    add(dem::Rectangle{{0, 0, rig.floor()}, {1, 0, 0}, {0, 1, 0}, reach, reach}, of_plate);
    add(dem::Cylinder{{0, 0, 0.5 * (bottom + top)}, up, 0.5 * (top - bottom), rig.radius}, of_vessel);
    if (rig.feed == Feed::fixed_funnel) {
        add(dem::Disc{{0, 0, rig.outlet_height}, up, rig.outlet_radius}, of_vessel);
        double const half = 0.5 * rig.cone_height();
        add(dem::Cone{{0, 0, rig.outlet_height + half}, up, half, rig.outlet_radius, rig.radius}, of_vessel);
    }
    if (rig.lip > 0)
        add(dem::Cylinder{{0, 0, 0.5 * rig.lip}, up, 0.5 * rig.lip, rig.plate_radius}, of_plate);
    return all;
}

//! In the order of the walls.
std::vector<std::string> wall_names(Setup const& rig)
{
    std::vector<std::string> names = {"plate", "floor",
                                      rig.feed == Feed::fixed_funnel ? "funnel" : "cylinder"};
    if (rig.feed == Feed::fixed_funnel)
        names.insert(names.end(), {"gate", "funnel"});
    if (rig.lip > 0)
        names.push_back("lip");
    return names;
}

//! The spheres lie loosely in the cylinder, or above the funnel, as high as they need, and will rain down.
Apparatus build(Setup const& rig)
{
    RandomStream size_stream(derive_seed(rig.seed, 1)), place_stream(derive_seed(rig.seed, 2));
    auto const sample = rig.grains.sample_whole(rig.mass, rig.density, size_stream);
    shape::Region const inside = shape::CylinderRegion{.from = {0, 0, rig.bottom_of_fill()},
                                                       .to = {0, 0, rig.top_of_fill()},
                                                       .radius = rig.radius,
                                                       .inner_radius = 0};
    auto const places = shape::place_in_region(
        rig.grains.outlines(sample), inside, {}, [](Vector3 const&, double) { return true; }, place_stream);
    Apparatus apparatus{.model = rig.model, .options = simulation_options(rig.options, rig.time_step)};
    double const reach = rig.furthest();
    apparatus.options.skin = rig.skin;
    apparatus.options.domain_lower = {-reach, -reach, rig.floor() - 0.1};
    apparatus.options.domain_upper = {reach, reach, rig.top_of_fill() + 1};
    apparatus.bodies = bodies_of(rig.grains, sample, places, material_id(rig.model, rig.material));
    apparatus.walls = walls(rig);
    return apparatus;
}

//! Mass that is still in or above the funnel, over all of it.
double share_in_funnel(Look& look, Setup const& rig)
{
    auto const& particles = look.grains();
    double mass = 0;
    for (std::size_t k = 0; k < particles.size(); ++k)
        if (particles.place(k).z > rig.outlet_height)
            mass += particles.mass(k);
    return mass / rig.mass;
}

bool heap_lies(Look& look, Setup const& rig)
{
    if (!rests(look, rig))
        return false;
    if (rig.feed == Feed::lifted_cylinder) // it has left the heap
        return dem::centre(look.simulation().wall(dem::WallId{vessel}).shape).z -
                   0.5 * (rig.top_of_fill() + rig.grains.widest()) >
               look.progress().series.column("height_mm").back() * 1e-3;
    double const left = share_in_funnel(look, rig);
    if (left > 0.02)
        throw RunFailure(
            RunStatus::timed_out,
            fmt::format(
                "an arch blocks the outlet: nothing moves, and {:.3g} % of the mass are still in the funnel",
                100 * left));
    return true;
}

std::vector<Stage> stages(Setup const& rig)
{
    Stage fill{.name = "fill",
               .until = [&rig](Look& look) { return rests(look, rig); },
               .waits_for = "the fill does not come to rest",
               .shortest = 0.1,
               .longest = rig.longest,
               .landmark = "filled"};
    Stage pour{.name = "pour",
               .until = [&rig](Look& look) { return heap_lies(look, rig); },
               .waits_for = "the heap does not come to rest",
               .shortest = 0.2,
               .longest = rig.longest + rig.expected_duration(),
               .looks_per_sample = 1,
               .landmark = "heap"};
    pour.enter = [&rig](Bench& bench) {
        if (rig.feed == Feed::lifted_cylinder)
            bench.simulation.move(dem::WallId{vessel}, dem::WallVelocity{.velocity = {0, 0, rig.lift_speed}});
        else
            bench.simulation.activate(dem::WallId{gate}, false);
    };
    std::vector<Stage> all = {fill};
    for (auto const& next : {rest_of(rig.options), {pour}})
        all.insert(all.end(), next.begin(), next.end());
    return all;
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input); // kept alive by `build`
    Programme programme{.time_step = setup->time_step,
                        .steps_per_look =
                            std::max<std::int64_t>(1, std::llround(setup->interval / setup->time_step)),
                        .expected_particles = setup->expected_particles(),
                        .work_per_particle = setup->grains.work_per_grain(),
                        .expected_duration = setup->expected_duration(),
                        .has_rigid_bodies = !setup->grains.are_spheres()};
    programme.check = [setup] { return size_warnings(setup->grains, setup->mass, setup->density); };
    programme.build = [setup] { return build(*setup); };
    programme.names.walls = wall_names(*setup);
    programme.stages = stages(*setup);
    auto const last = programme.stages.size() - 1;
    programme.readings = heap::readings(*setup);
    programme.profiles = heap::profiles(*setup, last);
    programme.responses = heap::responses(last);
    return programme;
}

} // namespace

RigInfo heap_rig()
{
    RigInfo rig{.name = "heap",
                .doc = "static angle of repose: a lifted cylinder or a funnel pours a heap on a plate",
                .options = heap::options(),
                .responses = heap::response_infos()};
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
