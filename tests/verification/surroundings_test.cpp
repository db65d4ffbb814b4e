// Drag and vibration against the closed forms of single particles; the ledger counts both; off they are
// nothing.
#include "demens/base/error.hpp"
#include "tests/support/impact.hpp"
#include "tests/support/motion.hpp"
#include "tests/support/small_bed.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::test;
using std::numbers::pi;

contact::Material const grain{"grain", 2500, 1e7, 0.3};

dem::Simulation one_sphere(double radius, dem::SimulationOptions const& options, Vector3 const& velocity = {})
{
    dem::Simulation simulation(one_material(grain, {}), options);
    simulation.add(dem::Body{.position = {}, .radius = radius, .velocity = velocity});
    return simulation;
}

TEST(Drag, SphereFallsAsStokesHasIt)
{
    // v = g tau (1 - exp(-t/tau)), tau = rho d^2/(18 eta); without the gas's density there is no Re.
    double const radius = 50e-6, viscosity = 1.8e-5, g = 9.81;
    double const tau = 2500 * 4 * radius * radius / (18 * viscosity);
    auto simulation = one_sphere(
        radius, {.time_step = 1e-4 * tau, .gravity = {0, 0, -g}, .surroundings = {.viscosity = viscosity}});
    for (int k = 1; k <= 8; ++k) {
        simulation.advance(10000);
        EXPECT_NEAR(-state_of(simulation).velocity(0).z, g * tau * (1 - std::exp(-k)), 1e-4 * g * tau) << k;
    }
}

TEST(Drag, TerminalVelocityFollowsSchillerAndNaumannAndNewton)
{
    // In air, and for the largest sphere beyond Re = 1000: m g = F(v), solved by bisection.
    double const viscosity = 1.8e-5, density = 1.2, g = 9.81;
    for (double const radius : {20e-6, 200e-6, 1e-3, 10e-3}) {
        double const mass = 2500 * 4.0 / 3 * pi * std::pow(radius, 3), d = 2 * radius;
        auto const drag = [&](double v) {
            double const re = density * v * d / viscosity;
            double const coefficient = re < 1000 ? 24 / re * (1 + 0.15 * std::pow(re, 0.687)) : 0.44;
            return coefficient * 0.5 * density * v * v * pi * radius * radius;
        };
        double low = 0, high = 100;
        for (int k = 0; k < 100; ++k)
            (drag(0.5 * (low + high)) < mass * g ? low : high) = 0.5 * (low + high);
        auto simulation = one_sphere(radius, {.time_step = 1e-3 * low / g,
                                              .surroundings = {.viscosity = viscosity, .density = density}});
        simulation.advance(20000);
        EXPECT_NEAR(-state_of(simulation).velocity(0).z, low, 1e-6 * low) << radius;
        EXPECT_NEAR(-state_of(simulation).force(0).z, -mass * g, 1e-6 * mass * g) << radius;
    }
}

TEST(Vibration, FreeParticleMovesAsTheIntegralHasIt)
{
    // Acceleration A sin(w t) from rest: v = A/w (1 - cos w t), x = A/w (t - sin(w t)/w).
    Vector3 const amplitude{3, 0, -5};
    double const w = 2 * pi * 40;
    auto simulation = one_sphere(
        1e-3, {.time_step = 1e-5, .gravity = {}, .surroundings = {.vibration = amplitude, .frequency = 40}});
    for (int k = 0; k < 10; ++k) {
        simulation.advance(371);
        double const t = simulation.time();
        auto const now = state_of(simulation);
        EXPECT_NEAR(norm(now.velocity(0) - (1 - std::cos(w * t)) / w * amplitude), 0, 1e-5 * 5 / w) << t;
        EXPECT_NEAR(norm(now.position(0) - (t - std::sin(w * t) / w) / w * amplitude), 0, 1e-5 * 5 * t / w)
            << t;
    }
}

dem::Simulation bed(dem::SimulationOptions const& options)
{
    contact::PairProperties pair;
    pair.rolling = contact::RollingLaw::epsd2;
    pair.rolling_friction = 0.1;
    return small_bed(grain, pair, 1e-3, options);
}

TEST(Surroundings, LedgerClosesAndCountsWhatTheyTakeAndGive)
{
    // A free sphere: all that falls is lost to drag; what shaking gives is work of the rig.
    double const mass = 2500 * 4.0 / 3 * pi * 1e-9;
    auto falling =
        one_sphere(1e-3, {.time_step = 1e-5, .surroundings = {.viscosity = 0.01}, .energy_ledger = true});
    falling.advance(200000);
    auto const fallen = falling.energy();
    auto const end = state_of(falling);
    EXPECT_NEAR(fallen.lost_to_damping,
                -mass * 9.81 * end.position(0).z - 0.5 * mass * norm_squared(end.velocity(0)),
                1e-6 * fallen.lost_to_damping);
    EXPECT_LT(std::abs(fallen.closure_error()), 1e-9);
    auto shaken = one_sphere(1e-3,
                             {.time_step = 1e-5,
                              .gravity = {},
                              .surroundings = {.vibration = {3, 0, 0}, .frequency = 40},
                              .energy_ledger = true},
                             {0.1, 0, 0});
    shaken.advance(1234);
    auto const work = shaken.energy();
    double const v = state_of(shaken).velocity(0).x;
    EXPECT_NEAR(work.work_of_walls, 0.5 * mass * (v * v - 0.01), 1e-4 * std::abs(work.work_of_walls));
    EXPECT_LT(std::abs(work.closure_error()), 1e-9);
    // And a bed in which all is mixed.
    auto simulation =
        bed({.surroundings = {.viscosity = 0.1, .density = 500, .vibration = {2, 0, 4}, .frequency = 60},
             .energy_ledger = true});
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
        simulation.advance(100);
        worst = std::max(worst, std::abs(simulation.energy().closure_error()));
    }
    EXPECT_EQ(simulation.health(), dem::Health::good);
    EXPECT_LT(worst, 5e-3);
}

TEST(Surroundings, OffTheyChangeNoBit)
{
    auto without = bed({});
    auto zero = bed({.surroundings = {.frequency = 123}});
    auto with = bed({.surroundings = {.viscosity = 1e-12}});
    for (auto* simulation : {&without, &zero, &with})
        simulation->advance(500);
    EXPECT_TRUE(same_motion(without, zero));
    EXPECT_FALSE(same_motion(without, with));
}

TEST(Surroundings, GoOnFromARecordWithTheSameBits)
{
    dem::SimulationOptions const options{
        .time_step = 1e-5,
        .surroundings = {.viscosity = 0.01, .density = 1, .vibration = {2, 0, 0}, .frequency = 60},
        .energy_ledger = true};
    auto const model = one_material(grain, {});
    auto whole = one_sphere(1e-3, options, {0.2, 0, 0});
    whole.advance(300);
    auto const record = whole.save();
    auto part = dem::Simulation::restore(model, options, record);
    whole.advance(200), part.advance(200);
    EXPECT_TRUE(same_motion(whole, part));
    EXPECT_EQ(whole.energy().lost_to_damping, part.energy().lost_to_damping);
    EXPECT_EQ(whole.energy().work_of_walls, part.energy().work_of_walls);
    auto still = options;
    still.surroundings = {};
    EXPECT_THROW(dem::Simulation::restore(model, still, record), InputError);
}

} // namespace
