// Walls that move: their surface velocity enters the contact, and what they feel balances what they do.
#include "demens/base/random.hpp"
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using demens::test::momenta_of;
using demens::test::state_of;

constexpr double g = 9.81, r = 0.01;

contact::Model stone(double friction, double rolling_friction = 0)
{
    contact::PairProperties pair;
    pair.static_friction = pair.kinetic_friction = friction;
    pair.rolling = rolling_friction > 0 ? contact::RollingLaw::constant_torque : contact::RollingLaw::none;
    pair.rolling_friction = rolling_friction;
    return demens::test::one_material({"stone", 2500, 1e7, 0.3}, pair);
}

double const mass = 2500 * 4.0 / 3 * std::numbers::pi * r * r * r;

Vector3 position(dem::Simulation& simulation, std::size_t k = 0)
{
    return state_of(simulation).position(k);
}

TEST(MovingWalls, SphereInATurningDrumRollsOnTheSpot)
{
    // The surfaces move alike where they touch, r w = R Omega, and with the constant rolling torque mu_r r N
    // the sphere rests where gravity balances it: tan(angle) = mu_r. The drum bears the weight at that lever.
    double const radius = 0.1, rate = 2;
    double const modulus = 1e7 / (2 * (1 - 0.09));
    double const overlap = std::pow(mass * g * 0.75 / (modulus * std::sqrt(r)), 2.0 / 3);
    for (double const mu_r : {0.0, 0.1}) {
        double const angle = std::atan(mu_r), distance = radius - r + overlap;
        dem::Simulation simulation(stone(0.5, mu_r), {.time_step = 2e-5, .skin = 2e-3});
        simulation.add(dem::Body{.position = {-distance * std::sin(angle), 0, -distance * std::cos(angle)},
                                 .radius = r,
                                 .spin = {0, rate * radius / r, 0}});
        simulation.add(dem::Wall{.shape = dem::Cylinder{{}, {0, 1, 0}, 0.05, radius}, .spin = {0, rate, 0}});
        simulation.advance(50000);
        Vector3 const p = position(simulation);
        EXPECT_NEAR(std::atan2(-p.x, -p.z), angle, 1e-3) << mu_r;
        EXPECT_NEAR(state_of(simulation).spin(0).y * r, rate * radius, 1e-3 * rate * radius) << mu_r;
        auto const load = simulation.read_wall_loads()[0];
        EXPECT_NEAR(load.force.z, -mass * g, 1e-3 * mass * g) << mu_r;
        EXPECT_NEAR(load.torque.y, p.x * mass * g, 1e-3 * mass * g * radius) << mu_r;
        EXPECT_EQ(simulation.counts().rebuilds, 1) << mu_r;
    }
}

TEST(MovingWalls, BeltCarriesASphereAlong)
{
    // A sphere put on a belt of speed u ends rolling; its centre gains 2/7 u (momentum about the contact).
    double const u = 0.5;
    dem::Simulation simulation(stone(0.3), {.time_step = 2e-5, .skin = 2e-3});
    simulation.add(dem::Body{{0, 0, r}, r});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}, .belt = {u, 0, 0}});
    simulation.advance(20000);
    EXPECT_NEAR(state_of(simulation).velocity(0).x, 2.0 / 7 * u, 2e-3 * u);
    EXPECT_EQ(dem::centre(simulation.walls()[0].shape), Vector3{});
}

TEST(MovingWalls, ShakenPlateRollsTheSphereOn)
{
    // Without slip the centre gains 2/7 of what the plate's speed changes: it shakes 2/7 as far.
    double const amplitude = 2e-3, frequency = 5;
    dem::Simulation simulation(stone(0.5), {.time_step = 1e-5, .skin = 2e-3});
    simulation.add(dem::Body{{0, 0, r}, r});
    auto const plate = simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.advance(50000); // settles on the plate
    double const at_first = position(simulation).x;
    simulation.move(plate, {{dem::Shake{{amplitude, 0, 0}, frequency, 0.5 * std::numbers::pi}}});
    double largest = 0;
    for (int k = 0; k < 40000; ++k) {
        simulation.advance(1);
        double const expected = 2.0 / 7 * dem::centre(simulation.wall(plate).shape).x;
        largest = std::max(largest, std::abs(position(simulation).x - at_first - expected));
    }
    EXPECT_LT(largest, 0.01 * 2.0 / 7 * amplitude);
    EXPECT_NEAR(dem::centre(simulation.wall(plate).shape).x, 0, 1e-12); // two full periods
}

TEST(MovingWalls, SphereFollowsAPlateThatRises)
{
    // Lifted at a tenth of g the sphere stays on the plate, which bears 1.1 weights at the lowest point.
    double const frequency = 10, angular = 2 * std::numbers::pi * frequency;
    double const amplitude = 0.1 * g / (angular * angular);
    dem::Simulation simulation(stone(0.5), {.time_step = 1e-5, .skin = 2e-3});
    simulation.add(dem::Body{{0, 0, r}, r});
    auto const plate = simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.move(plate, {{dem::Shake{{0, 0, amplitude}, frequency, -0.5 * std::numbers::pi}, 0.5}});
    simulation.advance(50000);
    double heaviest = 0, lightest = 1e9;
    for (int k = 0; k < 100000; ++k) {
        simulation.advance(1);
        double const load = -simulation.read_wall_loads()[plate.value].force.z / (mass * g);
        if (k > 50000)
            heaviest = std::max(heaviest, load), lightest = std::min(lightest, load);
    }
    EXPECT_NEAR(heaviest, 1.1, 0.005);
    EXPECT_NEAR(lightest, 0.9, 0.005);
}

TEST(MovingWalls, LoadsBalanceTheParticlesMomenta)
{
    // Without gravity, what the particles gain in momentum and in angular momentum about the pivot the walls
    // lose.
    Vector3 const pivot{0.02, -0.01, 0.03};
    dem::Simulation simulation(stone(0.5, 0.1), {.time_step = 2e-5, .gravity = {}, .skin = 2e-3});
    RandomStream random(4);
    for (int k = 0; k < 30; ++k)
        simulation.add(
            dem::Body{.position = {0.025 * (k % 3 - 1), 0.025 * (k / 3 % 3 - 1), 0.025 * (k / 9 - 1.5)},
                      .radius = r,
                      .velocity = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}});
    for (dem::WallShape const& shape :
         {dem::WallShape(dem::Cylinder{{}, {0, 0, 1}, 0.08, 0.06}),
          dem::WallShape(dem::Disc{{0, 0, -0.05}, {0, 0, 1}, 0.06}),
          dem::WallShape(dem::Cone{{0, 0, 0.065}, {0, 0, 1}, 0.02, 0.06, 0.001})})
        simulation.add(dem::Wall{.shape = shape, .spin = {0, 0, 5}, .pivot = pivot});
    Vector3 force, torque;
    auto const take_half = [&] {
        double const half = 0.5 * simulation.options().time_step;
        for (auto const& load : simulation.read_wall_loads())
            force += half * load.force, torque += half * load.torque;
    };
    simulation.advance(1);
    auto const before = momenta_of(simulation, pivot);
    int const steps = 5000;
    for (int k = 0; k < steps; ++k) {
        take_half(); // velocities of whole steps: each load acts for half of the step before and after it
        simulation.advance(1);
        take_half();
    }
    ASSERT_EQ(simulation.health(), dem::Health::good);
    auto const after = momenta_of(simulation, pivot);
    ASSERT_GT(norm(torque), 1e-4);
    EXPECT_LT(norm(after.linear - before.linear + force), 1e-12);
    // Exact in the leapfrog: a particle moves along its velocity, which adds nothing to m x cross v.
    EXPECT_LT(norm(after.angular - before.angular + torque), 1e-12);
}

} // namespace
