// Meshes against the shapes that they stand for.
#include "demens/base/random.hpp"
#include "tests/support/impact.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using demens::test::collide;
using demens::test::Collision;
using demens::test::drum_triangles;
using demens::test::mesh_of;
using demens::test::momenta_of;
using demens::test::one_material;
using demens::test::plane_triangles;
using demens::test::state_of;

constexpr double g = 9.81, r = 0.01;
contact::Material const stone{"stone", 2500, 1e7, 0.3};
dem::Rectangle const plane{{}, {1, 0, 0}, {0, 1, 0}, 1, 1};

contact::PairProperties frictional(double friction, double rolling_friction)
{
    contact::PairProperties pair;
    pair.static_friction = pair.kinetic_friction = friction;
    pair.rolling = rolling_friction > 0 ? contact::RollingLaw::epsd2 : contact::RollingLaw::none;
    pair.rolling_friction = rolling_friction;
    return pair;
}

Vector3 position(dem::Simulation& simulation)
{
    return state_of(simulation).position(0);
}

TEST(Mesh, APlaneAndItsMeshGiveTheSameRebound)
{
    // Normal, oblique and spinning impact on one pair of triangles and on triangles smaller than the contact.
    auto const hit = [](dem::WallShape const& wall, Vector3 const& velocity, Vector3 const& spin) {
        dem::Simulation simulation(one_material(stone, frictional(0.3, 0.1)),
                                   {.time_step = 1e-6, .gravity = {}, .skin = 1e-3});
        simulation.add(dem::Body{
            .position = {1e-4, 2e-4, r * (1 + 1e-9)}, .radius = r, .velocity = velocity, .spin = spin});
        simulation.add(dem::Wall{.shape = wall});
        return collide(simulation, true);
    };
    for (auto const& [velocity, spin] : {std::pair{Vector3{0, 0, -2}, Vector3{}},
                                         {Vector3{1.5, -0.4, -2}, Vector3{}},
                                         {Vector3{0.2, 0.1, -1}, Vector3{40, -30, 20}}}) {
        Collision const on_plane = hit(plane, velocity, spin);
        for (int const cells : {1, 60}) {
            Collision const on_mesh = hit(mesh_of(plane_triangles(0.02, cells)), velocity, spin);
            EXPECT_LT(norm(on_mesh.velocity[0] - on_plane.velocity[0]), 1e-9 * norm(velocity));
            EXPECT_LT(norm(on_mesh.spin[0] - on_plane.spin[0]), 1e-9 * norm(velocity) / r);
            EXPECT_NEAR(on_mesh.largest_force, on_plane.largest_force, 1e-9 * on_plane.largest_force);
            EXPECT_EQ(on_mesh.contact_time, on_plane.contact_time);
        }
    }
}

//! Path and energies of a sphere that is set off along a plane.
struct Journey
{
    std::vector<Vector3> path, velocity, spin;
};

Journey travel(dem::WallShape const& wall, contact::PairProperties const& pair, Vector3 const& velocity)
{
    dem::Simulation simulation(one_material(stone, pair),
                               {.time_step = 1e-5, .gravity = {0, 0, -g}, .skin = 1e-3});
    simulation.add(dem::Body{.position = {-0.08, -0.03, r}, .radius = r, .velocity = velocity});
    simulation.add(dem::Wall{.shape = wall});
    Journey journey;
    for (int k = 0; k < 30; ++k) {
        simulation.advance(1000);
        journey.path.push_back(position(simulation));
        journey.velocity.push_back(state_of(simulation).velocity(0));
        journey.spin.push_back(state_of(simulation).spin(0));
    }
    return journey;
}

TEST(Mesh, ASphereRollsAndSlidesOverAFineMeshAsOnThePlane)
{
    // It starts to slide, rolls, and with rolling friction slows down, over triangles of 20 and of 1 mm: some
    // 300 edges on its way.
    Vector3 const velocity{0.6, 0.3, 0};
    for (auto const& pair : {frictional(0.2, 0), frictional(0.05, 0), frictional(0.5, 0.05)}) {
        Journey const on_plane = travel(plane, pair, velocity);
        for (int const cells : {10, 200}) {
            Journey const on_mesh = travel(mesh_of(plane_triangles(0.15, cells)), pair, velocity);
            double const way = norm(on_plane.path.back() - on_plane.path.front());
            EXPECT_GT(way, 0.1);
            for (std::size_t k = 0; k < on_plane.path.size(); ++k) {
                EXPECT_LT(norm(on_mesh.path[k] - on_plane.path[k]), 1e-9 * way) << k;
                EXPECT_LT(norm(on_mesh.velocity[k] - on_plane.velocity[k]), 1e-8 * norm(velocity)) << k;
                EXPECT_LT(norm(on_mesh.spin[k] - on_plane.spin[k]), 1e-8 * norm(velocity) / r) << k;
            }
        }
    }
}

TEST(Mesh, ATiltedMeshInSinglePrecisionIsSmoothToo)
{
    // As an STL file has it: a plane at 30 degrees whose corners are rounded to single precision. Energy and
    // path to 0.1 %.
    Placement const tilt = turn_about({0.3, -0.2, 0.1}, {0, 1, 0}, std::numbers::pi / 6);
    auto soup = plane_triangles(0.15, 150);
    for (auto& triangle : soup)
        for (Vector3& p : triangle) {
            p = tilt(p);
            p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        }
    auto const roll = [&](dem::WallShape const& wall) {
        dem::Simulation simulation(one_material(stone, frictional(0.6, 0)),
                                   {.time_step = 1e-5, .skin = 1e-3});
        simulation.add(dem::Body{tilt({-0.1, 0.01, r}), r});
        simulation.add(dem::Wall{.shape = wall});
        simulation.advance(25000);
        return std::pair{position(simulation), simulation.kinetic_energy()};
    };
    auto const [path, energy] = roll(dem::placed(plane, tilt));
    auto const [mesh_path, mesh_energy] = roll(mesh_of(soup));
    double const way = norm(path - tilt({-0.1, 0.01, r}));
    EXPECT_NEAR(way, 0.5 * 5.0 / 7 * g * 0.5 * 0.25 * 0.25, 0.01 * way);
    EXPECT_LT(norm(mesh_path - path), 1e-3 * way);
    EXPECT_NEAR(mesh_energy, energy, 1e-3 * energy);
}

TEST(Mesh, FrictionHoldsASphereOnACornerOfTheMesh)
{
    // At rest on an incline, held by its histories, right over a corner where six triangles meet.
    auto const creep = [](dem::WallShape const& wall) {
        double const angle = 5 * std::numbers::pi / 180;
        auto pair = frictional(0.8, 0.4);
        dem::Simulation simulation(
            one_material(stone, pair),
            {.time_step = 2e-5, .gravity = {g * std::sin(angle), 0, -g * std::cos(angle)}, .skin = 1e-3});
        simulation.add(dem::Body{{0, 0, r}, r});
        simulation.add(dem::Wall{.shape = wall});
        simulation.advance(50000);
        return position(simulation);
    };
    auto soup = plane_triangles(0.05, 40);
    Vector3 const corner = shape::TriangleMesh(soup).vertices()[20 * 41 + 20];
    for (auto& triangle : soup)
        for (Vector3& p : triangle)
            p -= corner;
    Vector3 const on_plane = creep(plane), on_mesh = creep(mesh_of(soup));
    EXPECT_LT(std::abs(on_plane.x), 0.05 * r);
    EXPECT_LT(norm(on_mesh - on_plane), 1e-9 * r);
}

TEST(Mesh, ATurningDrumOfFacetsCarriesASphereLikeACylinder)
{
    // As in MovingWalls.SphereInATurningDrumRollsOnTheSpot, with 400 facets that pass under the sphere: on
    // average it lies where it does in the cylinder, spins as it does, and the drum bears its weight at that
    // lever.
    double const radius = 0.1, rate = 2, mu_r = 0.1, mass = 2500 * 4.0 / 3 * std::numbers::pi * r * r * r;
    auto pair = frictional(0.5, mu_r);
    pair.rolling = contact::RollingLaw::constant_torque;
    dem::Simulation simulation(one_material(stone, pair), {.time_step = 2e-5, .skin = 2e-3});
    double const angle = std::atan(mu_r), distance = radius - r;
    simulation.add(dem::Body{.position = {-distance * std::sin(angle), 0.003, -distance * std::cos(angle)},
                             .radius = r,
                             .spin = {0, rate * radius / r, 0}});
    auto const drum = simulation.add(dem::Wall{.shape = mesh_of(drum_triangles(radius, 0.05, 400, 12))});
    simulation.move(drum, {{dem::Rotate{{}, {0, 1, 0}, rate}}});
    simulation.advance(20000);
    Vector3 place, force, torque;
    double spin = 0;
    int const count = 100000;
    std::size_t most_contacts = 0;
    for (int k = 0; k < count; ++k) {
        simulation.advance(1);
        place += position(simulation) / count;
        spin += state_of(simulation).spin(0).y / count;
        force += simulation.read_wall_loads()[drum.value].force / count;
        torque += simulation.read_wall_loads()[drum.value].torque / count;
        most_contacts = std::max(most_contacts, simulation.counts().wall_contacts);
    }
    EXPECT_NEAR(std::atan2(-place.x, -place.z), angle, 0.01);
    EXPECT_NEAR(place.y, 0.003, 1e-4);
    EXPECT_NEAR(spin * r, rate * radius, 0.01 * rate * radius);
    EXPECT_NEAR(force.z, -mass * g, 0.01 * mass * g);
    EXPECT_NEAR(torque.y, place.x * mass * g, 0.01 * mass * g * radius);
    EXPECT_LE(most_contacts, 2u);
}

TEST(Mesh, LoadsBalanceTheParticlesMomenta)
{
    // Spheres in a shaken, turning box of triangles: what they gain in momentum and angular momentum it
    // loses.
    dem::Simulation simulation(one_material(stone, frictional(0.5, 0.1)),
                               {.time_step = 2e-5, .gravity = {}, .skin = 2e-3});
    RandomStream random(4);
    for (int k = 0; k < 27; ++k)
        simulation.add(
            dem::Body{.position = {0.025 * (k % 3 - 1), 0.025 * (k / 3 % 3 - 1), 0.025 * (k / 9 - 1)},
                      .radius = r,
                      .velocity = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}});
    auto const box = simulation.add(
        dem::Wall{.shape = mesh_of(shape::box_triangles({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}))});
    simulation.move(box, {{dem::Rotate{{0.01, 0, 0}, {1, 1, 0}, 3}}, {dem::Shake{{0, 0, 0.01}, 4}}});
    Vector3 force, torque; // about the origin
    auto const take_half = [&] {
        auto const load = simulation.read_wall_loads()[box.value];
        double const half = 0.5 * simulation.options().time_step;
        force += half * load.force;
        torque += half * (load.torque + cross(simulation.wall(box).pivot, load.force));
    };
    simulation.advance(1);
    auto const before = momenta_of(simulation, {});
    for (int k = 0; k < 5000; ++k) {
        take_half(); // velocities of whole steps: each load acts for half of the step before and after it
        simulation.advance(1);
        take_half();
    }
    ASSERT_EQ(simulation.health(), dem::Health::good);
    auto const after = momenta_of(simulation, {});
    ASSERT_GT(norm(torque), 1e-4);
    EXPECT_LT(norm(after.linear - before.linear + force), 1e-12);
    EXPECT_LT(norm(after.angular - before.angular + torque), 1e-12);
}

} // namespace
