// Closed forms of sliding and rolling on a plane, and of rest.
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double radius = 0.01, g = 9.81;
contact::Material const stone{"stone", 2500, 1e7, 0.3};

contact::PairProperties pair(double friction, contact::RollingLaw rolling, double rolling_friction)
{
    contact::PairProperties p;
    p.restitution = 0.3;
    p.static_friction = p.kinetic_friction = friction;
    p.rolling = rolling;
    p.rolling_friction = rolling_friction;
    return p;
}

//! A sphere that lies on the plane z = 0 at its static overlap.
dem::Simulation lying_sphere(contact::PairProperties const& p, Vector3 const& gravity,
                             Vector3 const& velocity, Vector3 const& spin)
{
    auto const model = one_material(stone, p);
    dem::Simulation simulation(model, {.time_step = 1e-5, .gravity = gravity, .skin = 1e-3});
    double const mass = 2500 * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
    double const modulus = 1e7 / (2 * (1 - 0.09));
    double const overlap = std::pow(-gravity.z * mass * 0.75 / (modulus * std::sqrt(radius)), 2.0 / 3);
    simulation.add(dem::Body{
        .position = {0, 0, radius - overlap}, .radius = radius, .velocity = velocity, .spin = spin});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6}});
    return simulation;
}

TEST(Rolling, SlipTurnsIntoRolling)
{
    // u = 5/7 u0 once slip has ended, whatever the friction.
    for (double const friction : {0.1, 0.3}) {
        auto simulation =
            lying_sphere(pair(friction, contact::RollingLaw::none, 0), {0, 0, -g}, {0.5, 0, 0}, {});
        simulation.advance(50000);
        EXPECT_NEAR(state_of(simulation).velocity(0).x, 5.0 / 7 * 0.5, 2e-3) << friction;
        EXPECT_NEAR(state_of(simulation).spin(0).y * radius, 5.0 / 7 * 0.5, 2e-3) << friction;
    }
}

TEST(Rolling, DecaysUnderConstantTorque)
{
    // w = w0 - 5 mu_r g t/(7 r) while it rolls without slip: the closed form of REFERENCE-VALUES.md,
    // 5 mu_r g t/(2 r), is that of a sphere spinning without friction, tested here as well.
    double const mu_r = 0.02, w0 = 20, t = 0.1;
    auto spinning =
        lying_sphere(pair(0, contact::RollingLaw::constant_torque, mu_r), {0, 0, -g}, {}, {0, w0, 0});
    spinning.advance(10000);
    EXPECT_NEAR(state_of(spinning).spin(0).y, w0 - 2.5 * mu_r * g * t / radius, 2e-3 * w0);
    auto rolling = lying_sphere(pair(0.5, contact::RollingLaw::constant_torque, mu_r), {0, 0, -g},
                                {w0 * radius, 0, 0}, {0, w0, 0});
    rolling.advance(10000);
    EXPECT_NEAR(state_of(rolling).spin(0).y, w0 - 5.0 / 7 * mu_r * g * t / radius, 2e-3 * w0);
}

TEST(Rolling, DecaysExponentiallyUnderViscousTorque)
{
    // M = -d m g R w: a sphere that spins without friction loses w at the rate 5 d g/(2 R), one that rolls at
    // 5 d g/(7 R).
    double const viscosity = 4e-3, w0 = 20, t = 0.1;
    for (bool const rolls : {false, true}) {
        auto p = pair(rolls ? 0.5 : 0.0, contact::RollingLaw::viscous, 0);
        p.rolling_viscosity = viscosity;
        auto simulation = lying_sphere(p, {0, 0, -g}, {rolls ? w0 * radius : 0.0, 0, 0}, {0, w0, 0});
        simulation.advance(10000);
        double const expected = w0 * std::exp(-(rolls ? 5.0 / 7 : 2.5) * viscosity * g * t / radius);
        EXPECT_NEAR(state_of(simulation).spin(0).y, expected, 1e-3 * w0) << rolls;
        EXPECT_LT(expected, 0.8 * w0);
    }
}

TEST(Rolling, ManyViscousContactsAtOnceDoNotTurnTheSpinRound)
{
    // A sphere held by four walls without friction: each takes its share of the spin, however viscous it is.
    auto p = pair(0, contact::RollingLaw::viscous, 0);
    p.rolling_viscosity = 1e3;
    auto simulation = lying_sphere(p, {0, 0, -g}, {}, {0, 20, 0});
    auto const wall = [&](Vector3 const& centre, Vector3 const& u, Vector3 const& v) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{centre, u, v, 1, 1}});
    };
    double const gap = 0.999 * radius;
    wall({gap, 0, radius}, {0, 1, 0}, {0, 0, 1});
    wall({-gap, 0, radius}, {0, 1, 0}, {0, 0, 1});
    wall({0, 0, radius + gap}, {1, 0, 0}, {0, 1, 0});
    double before = 20;
    for (int k = 0; k < 20; ++k) {
        simulation.advance(1);
        double const now = state_of(simulation).spin(0).y;
        EXPECT_GE(now, 0);
        EXPECT_LE(now, before);
        before = now;
    }
    EXPECT_LT(before, 0.1);
}

TEST(Rolling, DownAnInclineAgainstRollingFriction)
{
    // v = 5/7 g (sin - mu_r cos) t.
    double const angle = 20 * std::numbers::pi / 180, mu_r = 0.1, t = 0.3;
    for (auto const law :
         {contact::RollingLaw::constant_torque, contact::RollingLaw::epsd, contact::RollingLaw::epsd2}) {
        auto simulation =
            lying_sphere(pair(0.8, law, mu_r), {g * std::sin(angle), 0, -g * std::cos(angle)}, {}, {});
        simulation.advance(30000);
        double const expected = 5.0 / 7 * g * (std::sin(angle) - mu_r * std::cos(angle)) * t;
        EXPECT_NEAR(state_of(simulation).velocity(0).x, expected, 0.01 * expected) << static_cast<int>(law);
    }
}

TEST(Rolling, StaysOnAnInclineBelowTheRollingAngle)
{
    // Released at once, the undamped spring overshoots to twice its load: 2 tan 5 deg = 0.175 < mu_r.
    double const angle = 5 * std::numbers::pi / 180;
    for (auto const law : {contact::RollingLaw::epsd, contact::RollingLaw::epsd2}) {
        auto simulation =
            lying_sphere(pair(0.8, law, 0.2), {g * std::sin(angle), 0, -g * std::cos(angle)}, {}, {});
        simulation.advance(50000);
        EXPECT_LT(std::abs(state_of(simulation).place(0).x), 0.02 * radius) << static_cast<int>(law);
    }
}

TEST(Sliding, StaticFrictionIsOvercomeOnceAndKineticResists)
{
    // On an incline of 25 deg a block-like sphere (rotation locked by a huge rolling resistance), released at
    // once, loads its contact up to 2 tan 25 = 0.93: it holds for a larger mu_s, and for a smaller one slides
    // with g (sin - mu_k cos) although mu_s > tan 25 = 0.466.
    double const angle = 25 * std::numbers::pi / 180, t = 0.2;
    Vector3 const gravity{g * std::sin(angle), 0, -g * std::cos(angle)};
    for (auto const law : {contact::TangentialLaw::linear_coulomb, contact::TangentialLaw::mindlin_rescale}) {
        auto p = pair(0, contact::RollingLaw::epsd2, 100);
        p.tangential = law;
        p.static_friction = 1.0;
        p.kinetic_friction = 0.2;
        auto holds = lying_sphere(p, gravity, {}, {});
        holds.advance(20000);
        EXPECT_LT(std::abs(state_of(holds).velocity(0).x), 0.01) << static_cast<int>(law);
        p.static_friction = 0.5;
        auto slides = lying_sphere(p, gravity, {}, {});
        slides.advance(20000);
        double const expected = g * (std::sin(angle) - 0.2 * std::cos(angle)) * t;
        EXPECT_NEAR(state_of(slides).velocity(0).x, expected, 0.02 * expected) << static_cast<int>(law);
    }
}

TEST(Rest, FloorCarriesTheWeight)
{
    for (auto const normal : {contact::NormalLaw::hertz, contact::NormalLaw::hysteretic_spring}) {
        auto p = pair(0.5, contact::RollingLaw::epsd2, 0.1);
        p.normal = normal;
        dem::Simulation simulation(one_material(stone, p), {.time_step = 2e-5, .skin = 2e-3});
        RandomStream random(7);
        double mass = 0;
        for (int k = 0; k < 216; ++k) {
            double const r = random.uniform(0.6 * radius, radius);
            mass += 2500 * 4.0 / 3 * std::numbers::pi * r * r * r;
            simulation.add(dem::Body{.position = {0.0105 + 0.021 * (k % 6) + 1e-4 * random.uniform(),
                                                  0.0105 + 0.021 * (k / 6 % 6) + 1e-4 * random.uniform(),
                                                  0.011 + 0.021 * (k / 36)},
                                     .radius = r});
        }
        double const side = 6 * 0.021;
        auto const wall = [&](Vector3 centre, Vector3 u, Vector3 v) {
            return simulation.add(dem::Wall{.shape = dem::Rectangle{centre, u, v, 1, 1}});
        };
        auto const floor = wall({}, {1, 0, 0}, {0, 1, 0});
        dem::WallId const sides[] = {wall({}, {0, 1, 0}, {0, 0, 1}), wall({side, 0, 0}, {0, 1, 0}, {0, 0, 1}),
                                     wall({}, {0, 0, 1}, {1, 0, 0}),
                                     wall({0, side, 0}, {0, 0, 1}, {1, 0, 0})};
        simulation.advance(100000);
        ASSERT_EQ(simulation.health(), dem::Health::good);
        double carried = 0;
        for (int k = 0; k < 1000; ++k) {
            simulation.advance(1);
            auto const loads = simulation.read_wall_loads();
            carried -= loads[floor.value].force.z / 1000;
            for (auto const number : sides)
                carried -= loads[number.value].force.z / 1000;
        }
        EXPECT_NEAR(carried, mass * g, 2e-3 * mass * g) << static_cast<int>(normal);
    }
}

} // namespace
