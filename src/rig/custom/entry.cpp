#include "src/rig/custom/entry.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/common.hpp"
#include "src/rig/custom/body_overlap.hpp"
#include "src/rig/custom/geometry.hpp"
#include "src/rig/custom/surfaces.hpp"
#include "src/rig/one_grain.hpp"
#include "src/rig/option_specs.hpp"
#include "src/rig/seen_grains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

template <class Shape>
double distance_from(Shape const& shape, Vector3 const& place, double)
{
    return norm(place - nearest(shape, place));
}
double distance_from(dem::Mesh const& mesh, Vector3 const& place, double farthest)
{
    Vector3 const p = mesh.placement.inverse(place);
    double distance = farthest;
    mesh.mesh->tree().for_each_near(p, farthest, [&](std::uint32_t triangle) {
        distance = std::min(distance, norm(mesh.mesh->facets()[triangle].nearest(p).offset));
    });
    return distance;
}

//! How far a sphere reaches through a surface [m]; 0 or less where it does not touch.
double overlap_with(dem::Wall const& wall, Vector3 const& place, double radius)
{
    return radius -
           std::visit([&](auto const& shape) { return distance_from(shape, place, radius); }, wall.shape);
}

//! Walls that are still where they were given when a stage begins.
std::vector<WallPlan const*> walls_at_first_place(Setup const& setup, std::size_t stage)
{
    std::vector<WallPlan const*> walls;
    for (auto const& wall : setup.walls) {
        bool const has_moved = std::any_of(wall.motions.begin(), wall.motions.end(),
                                           [&](auto const& motion) { return motion.from_stage < stage; });
        if (setup.is_on(wall, stage) && !has_moved)
            walls.push_back(&wall);
    }
    return walls;
}

void check_in_domain(Setup const& setup, Body const& body)
{
    if (!shape::contains(shape::Region(setup.domain()), body.place))
        throw InputError(fmt::format("{} at {} is outside the domain, from {} to {}; move it or give "
                                     "domain_lower_mm and domain_upper_mm",
                                     body.origin, in_millimetres(body.place),
                                     in_millimetres(setup.options.domain_lower),
                                     in_millimetres(setup.options.domain_upper)));
}

void check_bodies(Setup const& setup, ParticleGroup const& group, std::vector<Body> const& bodies)
{
    auto const walls = walls_at_first_place(setup, group.stage);
    for (auto const& body : bodies) {
        check_in_domain(setup, body);
        for (auto const* wall : walls)
            for (auto const& part : wall->parts)
                for_each_ball(body, [&](Vector3 const& centre, double radius, double compared) {
                    double const overlap = overlap_with(part, centre, radius);
                    if (overlap > setup.overlap_limit * compared)
                        throw InputError(fmt::format(
                            "{} at {}, radius {:.4g} mm, reaches {:.4g} mm into the wall {}", body.origin,
                            in_millimetres(body.place), 1e3 * body.radius, 1e3 * overlap, wall->name));
                });
    }
}

void check_packing(Setup const& setup, ParticleGroup const& group, Packing const& packing)
{
    auto const box = shape::bounds(packing.region);
    Vector3 const extent = box.upper - box.lower;
    if (std::min({extent.x, extent.y, extent.z}) < packing.grains->widest())
        throw InputError(
            fmt::format("particles.{}: no room for the particles: the largest sphere, {:.4g} mm, does not "
                        "fit into its region",
                        group.name, 1e3 * packing.grains->widest()));
    check_in_domain(setup,
                    {.place = box.lower, .origin = fmt::format("the region of particles.{}", group.name)});
    check_in_domain(setup,
                    {.place = box.upper, .origin = fmt::format("the region of particles.{}", group.name)});
    auto const walls = walls_at_first_place(setup, group.stage);
    auto const is_free = [&](Vector3 const& p, double r) {
        if (packing.within && !shape::contains(*packing.within, p, r))
            return false;
        for (auto const* wall : walls)
            for (auto const& part : wall->parts)
                if (overlap_with(part, p, r) > 0)
                    return false;
        return true;
    };
    RandomStream sizes(1);
    double solid = 0;
    for (auto const& [d, kind] : sample_of(packing, setup.density(group), sizes))
        solid += std::numbers::pi / 6 * d * d * d;
    double const room = shape::free_volume(packing.region, 0.25 * packing.grains->smallest_ball(), is_free);
    double const densest = 0.33 * packing.grains->looseness();
    if (solid > densest * room)
        throw InputError(
            fmt::format("particles.{}: no room for the particles: they have {:.4g} mm^3, their region "
                        "{:.4g} mm^3, of which random places fill at most {:.2g}; make the region larger, "
                        "e.g. higher, and let them settle",
                        group.name, 1e9 * solid, 1e9 * room, densest));
}

//! A place as it is seen from above, at another height [m].
Vector3 at_height(Setup const& setup, Vector3 const& place, double height)
{
    auto upright = setup.upright.upright(place);
    upright.z = height;
    return setup.upright.back(upright);
}

//! Of a body that enters at a clearance above the others.
void check_above_others(Setup const& setup, ParticleGroup const& group, Body body)
{
    Vector3 const middle = 0.5 * (setup.options.domain_lower + setup.options.domain_upper);
    body.place = at_height(setup, body.place, setup.upright.height(middle));
    check_in_domain(setup, body);
    for (auto const& other : setup.groups) {
        if (&other == &group)
            break;
        if (other.stage <= group.stage)
            return;
    }
    for (auto const& other : setup.groups)
        if (other.stage < group.stage)
            return;
    throw InputError(
        fmt::format("particles.{} enters at a clearance above the other particles, but there are none "
                    "then; let it enter at a later stage",
                    group.name));
}

//! Particles by their ids.
std::vector<std::size_t> in_order(dem::StateView const& particles)
{
    std::vector<std::size_t> order(particles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return particles.id(a).value < particles.id(b).value; });
    return order;
}

constexpr char const* is_there = "a particle there";

std::vector<Body> as_bodies(std::vector<dem::HullPlace> const& hulls)
{
    std::vector<Body> bodies;
    for (auto const& hull : hulls)
        bodies.push_back({.place = hull.position,
                          .radius = hull.radius,
                          .origin = is_there,
                          .shape = hull.shape,
                          .orientation = hull.orientation});
    return bodies;
}

//! What is there: spheres, those of clumps by themselves, and polyhedra.
std::vector<Body> existing(Look& look)
{
    auto const& particles = look.particles();
    auto const hulls = look.simulation().read_hulls();
    auto bodies = as_bodies(hulls);
    for (std::size_t const k : in_order(particles))
        if (!is_of_hull(hulls, particles.id(k)))
            bodies.push_back(
                {.place = particles.position(k), .radius = particles.radius(k), .origin = is_there});
    return bodies;
}

//! Whether a sphere reaches over a border beyond which everything repeats itself: what it would meet there is
//! not looked at.
bool crosses_border(dem::Periods const& periods, Vector3 const& place, double radius)
{
    auto const crosses = [radius](dem::Period const& period, double at) {
        return period.on() && (at - radius < period.lower || at + radius > period.upper);
    };
    return crosses(periods.x, place.x) || crosses(periods.y, place.y);
}

//! \param batch from 0 on; each has its own places
std::vector<Body> fill(Look& look, Setup const& setup, std::size_t number, Packing const& packing, int batch)
{
    auto const first = derive_seed(setup.seed, number + 1);
    auto const stream = batch == 0 ? first : derive_seed(first, 2 + static_cast<std::uint64_t>(batch));
    RandomStream sizes(derive_seed(stream, 1)), places(derive_seed(stream, 2));
    auto const sample = sample_of(packing, setup.density(setup.groups[number]), sizes);
    std::vector<shape::Sphere> obstacles;
    for (std::size_t const k : in_order(look.particles()))
        obstacles.push_back({look.particles().position(k), look.particles().radius(k)});
    auto const hulls = as_bodies(look.simulation().read_hulls()); // the spheres that fill them leave gaps
    auto const is_free = [&](Vector3 const& p, double r) {
        if ((packing.within && !shape::contains(*packing.within, p, r)) ||
            crosses_border(setup.options.periodic, p, r))
            return false;
        for (Body const& hull : hulls)
            if (overlap_of({.place = p, .radius = r}, hull).depth > 0)
                return false;
        auto const& walls = look.simulation().walls();
        return std::none_of(walls.begin(), walls.end(), [&](dem::Wall const& wall) {
            return wall.active && overlap_with(wall, p, r) > 0;
        });
    };
    auto const found =
        shape::place_in_region(packing.grains->outlines(sample), packing.region, obstacles, is_free, places);
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < found.size(); ++k)
        bodies.push_back({.place = found[k].centre,
                          .radius = 0.5 * sample[k].diameter,
                          .velocity = packing.velocity,
                          .shape = packing.grains->shape_of(sample[k]).shape,
                          .orientation = found[k].orientation});
    return bodies;
}

//! Height of the mean surface of the particles: columns half a mean radius wide [m].
double level_of(Look& look, Upright const& upright)
{
    auto const seen = upright_grains(look, upright, {});
    auto const& particles = look.particles();
    double radius = 0;
    for (std::size_t k = 0; k < particles.size(); ++k)
        radius += particles.radius(k) / static_cast<double>(particles.size());
    return observe::surface_map(seen.balls, 0.5 * radius, seen.hulls).mean_height();
}

//! The bodies of a group as they enter now.
std::vector<Body> bodies_of(Look& look, Setup const& setup, std::size_t number)
{
    auto const& source = setup.groups[number].source;
    if (auto const* packing = std::get_if<Packing>(&source))
        return fill(look, setup, number, *packing, 0);
    auto bodies = std::get<ParticleTable>(source).bodies;
    if (auto const& clearance = setup.groups[number].clearance) {
        double const level = level_of(look, setup.upright);
        look.progress().groups[number].level = level;
        for (auto& body : bodies) {
            double const depth =
                reach_along(body.shape.get(), body.radius, body.orientation, setup.upright.back({0, 0, -1}));
            body.place = at_height(setup, body.place, level + *clearance + depth);
        }
    }
    auto all = existing(look);
    auto const old = all.size();
    all.insert(all.end(), bodies.begin(), bodies.end());
    check_overlaps(all, old, setup.overlap_limit);
    return bodies;
}

} // namespace

void check_places(Setup const& setup)
{
    for (std::size_t stage = 0; stage < setup.stages.size(); ++stage) {
        std::vector<Body> together;
        for (auto const& group : setup.groups) {
            if (group.stage != stage)
                continue;
            if (auto const* packing = std::get_if<Packing>(&group.source)) {
                check_packing(setup, group, *packing);
                continue;
            }
            auto const& bodies = std::get<ParticleTable>(group.source).bodies;
            if (group.clearance) {
                check_above_others(setup, group, bodies.front());
            } else {
                check_bodies(setup, group, bodies);
                together.insert(together.end(), bodies.begin(), bodies.end());
            }
        }
        check_overlaps(together, 0, setup.overlap_limit);
    }
}

namespace {

dem::IdRange add(Bench& bench, Setup const& setup, ParticleGroup const& group,
                 std::vector<Body> const& bodies)
{
    dem::MaterialId const material = material_id(setup.model, group.material);
    dem::BodyBatch batch;
    for (auto const& body : bodies)
        batch.push_back(
            {body.place, body.radius, material, body.velocity, body.spin, body.shape, body.orientation});
    return bench.simulation.add(batch);
}

} // namespace

void enter(Bench& bench, Setup const& setup, std::size_t stage)
{
    DEMENS_EXPECT(stage < setup.stages.size(), "a stage of the bench");
    bench.progress.groups.resize(setup.groups.size());
    for (std::size_t g = 0; g < setup.groups.size(); ++g) {
        if (setup.groups[g].stage != stage)
            continue;
        Look look(bench);
        auto const bodies = bodies_of(look, setup, g);
        auto& ids = bench.progress.groups[g].ids;
        DEMENS_EXPECT(ids.size() == 0, "a group enters once");
        ids = add(bench, setup, setup.groups[g], bodies);
    }
}

void pour(Bench& bench, Setup const& setup, std::size_t stage)
{
    double const now = bench.time_in_stage() + 0.5 * setup.options.time_step;
    for (std::size_t g = 0; g < setup.groups.size(); ++g) {
        auto const& group = setup.groups[g];
        if (group.stage != stage || !group.is_inlet())
            continue;
        auto const& packing = std::get<Packing>(group.source);
        double& batches = bench.progress.notes["later batches of " + group.name];
        while (batches + 1 < packing.batches && now >= (batches + 1) * packing.every) {
            batches += 1;
            Look look(bench);
            auto const more =
                add(bench, setup, group, fill(look, setup, g, packing, static_cast<int>(batches)));
            auto& ids = bench.progress.groups[g].ids;
            DEMENS_EXPECT(more.first == ids.end, "nobody else enters meanwhile");
            ids.end = more.end;
        }
    }
}

void check_room_for_wall(Bench& bench, Setup const& setup, WallPlan const& plan, dem::Wall const& part,
                         std::string const& stage)
{
    Look look(bench);
    for (auto const& p : look.particles().places()) {
        Vector3 const place{p.x, p.y, p.z};
        double const overlap = overlap_with(part, place, p.radius);
        if (overlap > setup.overlap_limit * p.radius)
            throw InputError(fmt::format(
                "the wall {} appears in stage \"{}\" where a particle is: at {}, radius {:.4g} mm, it "
                "reaches "
                "{:.4g} mm into it, {:.3g} of the radius, where initial_overlap = {:.3g}; switch it on "
                "earlier or move it there",
                plan.name, stage, in_millimetres(place), 1e3 * p.radius, 1e3 * overlap, overlap / p.radius,
                setup.overlap_limit));
    }
}

} // namespace demens::rig::custom
