// Rounded hulls on meshes: flat ones as planes, ridges and corners that stand out, hollows, energy.
#include "demens/shape/packing.hpp"
#include "tests/support/meshes.hpp"
#include "tests/verification/hull_scene.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace demens;
using namespace demens::test;

//! Motion of a box that slides and turns over a floor.
std::vector<Vector3> slide(dem::WallShape const& wall)
{
    dem::Simulation simulation(model(0.3, 0.4), {.time_step = 5e-6, .skin = 1e-3});
    auto const cube = box(1, 1.2, 0.9);
    simulation.add(dem::Wall{.shape = wall});
    simulation.add(body_of(cube, {-0.02, -0.013, half_sides(*cube).z * 1.01}, {0.4, 0.25, 0}, {0, 0, 30}));
    std::vector<Vector3> path;
    for (int k = 0; k < 20; ++k) {
        simulation.advance(1000);
        auto const grains = grains_of(simulation);
        path.push_back(grains.position(0));
        path.push_back(grains.spin(0));
    }
    EXPECT_EQ(simulation.health(), dem::Health::good);
    return path;
}

TEST(HullsOnMeshes, SlideOverAMeshAsOverAPlane)
{
    auto const on_plane = slide(dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1});
    EXPECT_GT(on_plane[on_plane.size() - 2].x, 0) << "across the middle";
    for (int const cells : {1, 40}) {
        auto const on_mesh = slide(mesh_of(plane_triangles(0.1, cells)));
        for (std::size_t k = 0; k < on_plane.size(); ++k)
            EXPECT_LT(norm(on_mesh[k] - on_plane[k]), 1e-6 * (k % 2 == 0 ? radius : 30))
                << cells << ": " << k;
    }
}

//! The surface of a body between flat faces, each given by its corners in turn.
shape::TriangleSoup surface(std::vector<std::vector<Vector3>> const& faces)
{
    shape::TriangleSoup soup;
    for (auto const& face : faces)
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            soup.push_back({face[0], face[k], face[k + 1]});
    return soup;
}

void add(shape::TriangleSoup& soup, shape::TriangleSoup const& more)
{
    soup.insert(soup.end(), more.begin(), more.end());
}

//! A roof whose ridge is along y at x, z = 0.
shape::TriangleSoup roof(double x, double half_length)
{
    Vector3 const a{x, -half_length, 0}, b{x, half_length, 0}, down{0, 0, -radius}, aside{radius, 0, 0};
    return surface({{a, b, b + down + aside, a + down + aside}, {b, a, a + down - aside, b + down - aside}});
}

//! A plate at rest on what it lies on; its height above it [m].
double height_of_plate(shape::TriangleSoup const& under)
{
    auto const plate = box(3, 3, 1);
    double const half = half_sides(*plate).z;
    dem::Simulation simulation(model(0.1, 0.8), {.time_step = 5e-6, .skin = 1e-3});
    simulation.add(dem::Wall{.shape = mesh_of(under)});
    simulation.add(body_of(plate, {0, 0, 1.001 * half}));
    simulation.advance(30000);
    EXPECT_LT(simulation.kinetic_energy(), 1e-9);
    EXPECT_NEAR(simulation.read_wall_loads()[0].force.z, -mass * g, 1e-3 * mass * g);
    EXPECT_EQ(simulation.health(), dem::Health::good);
    return grains_of(simulation).position(0).z - half;
}

TEST(HullsOnMeshes, LieOnRidgesAndOnCorners)
{
    // No corner of the plate is near: its edges lie on ridges, or its face on corners.
    double const little = 0.02 * radius;
    auto ridges = roof(-0.8 * radius, 4 * radius);
    add(ridges, roof(0.8 * radius, 4 * radius));
    EXPECT_NEAR(height_of_plate(ridges), 0, little);
    auto short_ridges = roof(-0.8 * radius, 0.5 * radius); // their ends touch the face
    add(short_ridges, roof(0.8 * radius, 0.5 * radius));
    EXPECT_NEAR(height_of_plate(short_ridges), 0, little);
    shape::TriangleSoup tips;
    for (double const x : {-0.7 * radius, 0.7 * radius})
        for (double const y : {-0.7 * radius, 0.7 * radius}) {
            Vector3 const tip{x, y, 0}, base{x, y, -radius}, u{0.5 * radius, 0, 0}, v{0, 0.5 * radius, 0};
            std::array const feet{base + u, base + v, base - u, base - v};
            for (std::size_t k = 0; k < 4; ++k)
                tips.push_back({tip, feet[k], feet[(k + 1) % 4]});
        }
    EXPECT_NEAR(height_of_plate(tips), 0, little);
    shape::TriangleSoup const pedestal =
        shape::box_triangles({-radius, -radius, -radius}, {radius, radius, 0});
    EXPECT_NEAR(height_of_plate(pedestal), 0, little);
}

TEST(HullsOnMeshes, StayOnAPlateOrFallOverItsEdge)
{
    auto const cube = box(1, 1, 1);
    double const half = half_sides(*cube).z, size = 10 * radius;
    for (double const beyond : {-0.3, 0.3}) {
        dem::Simulation plate(model(0.3, 0.8), {.time_step = 5e-6, .skin = 1e-3});
        plate.add(dem::Wall{.shape = mesh_of(plane_triangles(size, 13))});
        plate.add(body_of(cube, {size + beyond * radius, 0.3 * radius, half}));
        plate.advance(30000);
        double const z = grains_of(plate).position(0).z;
        if (beyond < 0)
            EXPECT_NEAR(z, half, 2e-2 * half);
        else
            EXPECT_LT(z, -radius);
    }
}

TEST(HullsOnMeshes, AreHeldByADrumThatTurns)
{
    // A drum of 72 facets that has turned: the weight is on the wall, and no corner is beyond it.
    auto const cube = box(1, 1, 1);
    double const wide = 8 * radius;
    dem::Simulation drum(model(0.3, 0.5), {.time_step = 5e-6, .skin = 1e-3});
    auto const wall = drum.add(dem::Wall{.shape = mesh_of(drum_triangles(wide, 5 * radius, 72, 3))});
    drum.add(body_of(cube, {0, 0, -wide + 1.3 * half_sides(*cube).z}));
    drum.advance(20000);
    drum.move(wall, {.spin = {0, 2, 0}});
    drum.advance(20000);
    drum.move(wall, dem::WallVelocity{});
    drum.advance(60000);
    EXPECT_LT(drum.kinetic_energy(), 1e-7);
    EXPECT_NEAR(drum.read_wall_loads()[0].force.z, -mass * g, 2e-2 * mass * g);
    EXPECT_EQ(drum.health(), dem::Health::good);
}

TEST(HullsOnMeshes, LieOnTheOutsideOfADrumOfManyFacets)
{
    auto const plate = box(3, 3, 1);
    double const half = half_sides(*plate).z, wide = 20 * radius;
    dem::Simulation outside(model(0.1, 0.8), {.time_step = 5e-6, .skin = 1e-3});
    auto mesh = mesh_of(drum_triangles(wide, 5 * radius, 120, 4));
    mesh.placement.shift = {0, 0, -wide};
    outside.add(dem::Wall{.shape = mesh});
    outside.add(body_of(plate, {0, 0, half}));
    outside.advance(10000);
    EXPECT_NEAR(grains_of(outside).position(0).z, half, 1e-2 * half);
    EXPECT_NEAR(outside.read_wall_loads()[0].force.z, -mass * g, 0.05 * mass * g);
    EXPECT_EQ(outside.health(), dem::Health::good);
}

//! Hulls that fly about in a box with an obelisk in its middle, elastic and without friction.
dem::Simulation flight(std::shared_ptr<grain::BodyShape const> const& shape)
{
    double const spacing = 2.1 * shape->reach() * radius, side = 3 * spacing, middle = 0.5 * side;
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    dem::Simulation simulation(one_material(stone, pair), {.time_step = 2e-6, .gravity = {}, .skin = 1e-3});
    RandomStream random(5);
    auto const any = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    for (int k = 0; k < 9; ++k) {
        if (k == 4)
            continue; // there it stands
        for (double const z : {0.5, 2.5})
            simulation.add(body_of(shape, spacing * Vector3{0.5 + k % 3, 0.5 + k / 3, z}, any(1), any(100),
                                   shape::random_orientation(random)));
    }
    simulation.add(dem::Wall{.shape = mesh_of(shape::box_triangles({}, {side, side, side}))});
    Vector3 const tip{middle, middle, 0.8 * side};
    double const foot = 0.4 * spacing;
    std::array const feet{Vector3{middle + foot, middle, 0}, Vector3{middle, middle + foot, 0},
                          Vector3{middle - foot, middle, 0}, Vector3{middle, middle - foot, 0}};
    shape::TriangleSoup obelisk;
    for (std::size_t k = 0; k < 4; ++k)
        obelisk.push_back({tip, feet[k], feet[(k + 1) % 4]});
    simulation.add(dem::Wall{.shape = mesh_of(obelisk)});
    return simulation;
}

TEST(HullsOnMeshes, KeepEnergyAmongWallsAndAnObelisk)
{
    for (auto const& shape : {box(1, 1, 1, 0.06), shape_of(grain::tetrahedron_hull(1), 0.05)}) {
        auto simulation = flight(shape);
        simulation.advance(0);
        double const energy = simulation.kinetic_energy();
        std::size_t hits = 0, touching = 0, moments = 0;
        for (int k = 0; hits < 200 && k < 5000; ++k) {
            simulation.advance(20);
            std::size_t const now = simulation.counts().wall_contacts;
            hits += now > touching ? now - touching : 0;
            touching = now;
            if (now + simulation.counts().contacts > 0)
                continue;
            ++moments;
            EXPECT_NEAR(simulation.kinetic_energy(), energy, 1e-4 * energy) << hits;
        }
        EXPECT_GT(moments, 5u) << "at which none touches";
        EXPECT_GE(hits, 200u);
        EXPECT_EQ(simulation.health(), dem::Health::good);
    }
}

TEST(HullsOnMeshes, GoOnFromARecordWithTheSameBits)
{
    auto const coefficients = model(0.4, 0.5);
    dem::SimulationOptions const options{.time_step = 4e-6, .skin = 1e-3};
    dem::Simulation whole(coefficients, options);
    whole.add(dem::Wall{.shape = mesh_of(drum_triangles(6 * radius, 3 * radius, 24, 2)), .spin = {0, 3, 0}});
    for (int k = 0; k < 6; ++k)
        whole.add(body_of(box(1, 1.3, 0.8), {(k % 3 - 1) * 2.2 * radius, 0, (k / 3 - 1) * 2.2 * radius}));
    whole.advance(18000);
    auto rest = dem::Simulation::restore(coefficients, options,
                                         dem::StateRecord::from_bytes(whole.save().to_bytes()));
    whole.advance(4000), rest.advance(4000);
    EXPECT_TRUE(same_motion(whole, rest));
    EXPECT_GT(whole.counts().wall_contacts, 0u);
}

} // namespace
