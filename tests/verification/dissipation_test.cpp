// No set of laws gives bodies more energy than they had, and constant_torque stops and holds.
#include "demens/base/random.hpp"
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::test;

contact::Material const stone{"stone", 2500, 1e7, 0.3};
constexpr double r = 2e-3, g = 9.81;

double energy_of(dem::StateView const& view)
{
    double energy = 0;
    for (std::size_t k = 0; k < view.size(); ++k)
        energy += 0.5 * view.mass(k) * norm_squared(view.velocity(k)) +
                  0.5 * view.inertia(k) * norm_squared(view.spin(k));
    return energy;
}

//! A spinning sphere that hits a plane, or one that does not move.
struct Hit
{
    Vector3 velocity, spin;
    bool with_wall;
};

//! Energy after over energy before.
double energy_kept(contact::PairProperties const& pair, Hit const& hit)
{
    // A stiff linear spring takes a smaller step for the same error.
    double const share = pair.normal == contact::NormalLaw::hertz ? 0.05 : 0.005;
    dem::Simulation simulation(
        one_material(stone, pair),
        {.time_step = share * dem::rayleigh_time(r, stone), .gravity = {}, .skin = 0.5 * r});
    if (hit.with_wall)
        simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    else
        simulation.add(dem::Body{{0, 0, -r}, r});
    simulation.add(dem::Body{{0, 0, r * (1 + 1e-9)}, r, {}, hit.velocity, hit.spin});
    double const before = energy_of(simulation.read(dem::Fields::all));
    for (int k = 0; k < 10000; ++k) {
        simulation.advance(100);
        auto const counts = simulation.counts();
        if (counts.contacts + counts.wall_contacts == 0)
            return energy_of(simulation.read(dem::Fields::all)) / before;
    }
    ADD_FAILURE() << "the bodies do not part";
    return 0;
}

//! The most of some impacts at random angles and spins, with friction and rolling friction from little to
//! more than holds.
double most_energy_kept(contact::PairProperties pair, bool with_wall)
{
    double most = 0;
    RandomStream random(3);
    for (int k = 0; k < 24; ++k) {
        double const angle = random.uniform(0, 80) * std::numbers::pi / 180, spin = k % 3 == 0 ? 0 : 300;
        auto const turn = [&] { return random.uniform(-spin, spin); };
        double const x = turn(), y = turn(), z = turn();
        pair.restitution = k % 2 ? 1 : 0.7;
        pair.static_friction = pair.kinetic_friction = k % 4 < 2 ? 0.3 : 5;
        pair.rolling_friction = k % 5 < 2 ? 0.1 : k % 5 < 4 ? 2 : 50;
        pair.rolling_damping = k % 7 < 3 ? 0 : 0.3;
        Hit const hit{0.5 * Vector3{std::sin(angle), 0, -std::cos(angle)}, {x, y, z}, with_wall};
        most = std::max(most, energy_kept(pair, hit));
    }
    return most;
}

//! The springs of these remember a displacement and become stiffer while it stays, so that they create energy
//! in loading; where rolling resistance holds the spin it is seen. The input's description says so.
bool gains_in_loading(contact::TangentialLaw law, contact::RollingLaw rolling)
{
    return rolling != contact::RollingLaw::none &&
           (law == contact::TangentialLaw::mindlin || law == contact::TangentialLaw::mindlin_deresiewicz);
}

TEST(Dissipation, NoSetOfLawsGivesEnergy)
{
    for (auto const& normal : contact::normal_laws)
        for (auto const& tangential : contact::tangential_laws)
            for (auto const& rolling : contact::rolling_laws)
                for (bool const with_wall : {true, false}) {
                    if (gains_in_loading(tangential.law, rolling.law))
                        continue;
                    contact::PairProperties pair;
                    pair.normal = normal.law;
                    pair.tangential = tangential.law;
                    pair.rolling = rolling.law;
                    pair.rolling_viscosity = 1e-3;
                    EXPECT_LT(most_energy_kept(pair, with_wall), 1 + 1e-3)
                        << normal.text << ' ' << tangential.text << ' ' << rolling.text
                        << (with_wall ? " on a wall" : " on a sphere");
                }
}

//! A sphere on a plane at its static overlap.
dem::Simulation lying(double mu_r, Vector3 const& gravity, Vector3 const& spin)
{
    contact::PairProperties pair;
    pair.static_friction = pair.kinetic_friction = 0.8;
    pair.rolling = contact::RollingLaw::constant_torque;
    pair.rolling_friction = mu_r;
    dem::Simulation simulation(
        one_material(stone, pair),
        {.time_step = 0.2 * dem::rayleigh_time(r, stone), .gravity = gravity, .skin = 0.2 * r});
    double const mass = 2500 * 4.0 / 3 * std::numbers::pi * r * r * r, modulus = 1e7 / (2 * 0.91);
    double const overlap = std::pow(-gravity.z * mass * 0.75 / (modulus * std::sqrt(r)), 2.0 / 3);
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.add(dem::Body{{0, 0, r - overlap}, r, {}, {}, spin});
    return simulation;
}

TEST(ConstantTorque, StopsASpinAsItsTorqueSaysAndThenRests)
{
    // mu_r R m g against 2/5 m R^2: the spin falls by 5 mu_r g/(2 R) in a second. In 100 g it is a few
    // steps'.
    for (double const gravity : {g, 100 * g}) {
        auto simulation = lying(0.1, {0, 0, -gravity}, {0, 0, 50});
        double const dt = simulation.options().time_step, rate = 2.5 * 0.1 * gravity / r;
        auto const half = static_cast<std::int64_t>(25 / (rate * dt));
        simulation.advance(half);
        double const expected = 50 - rate * static_cast<double>(half) * dt;
        EXPECT_NEAR(simulation.read(dem::Fields::all).spin(0).z, expected, gravity > g ? 20 : 0.5);
        simulation.advance(half + 400);
        EXPECT_LT(norm(simulation.read(dem::Fields::all).spin(0)), 1e-6);
    }
}

TEST(ConstantTorque, HoldsOnASlopeBelowItsAngle)
{
    // Of 3 degrees where rolling friction holds up to 5.7. It crept at 26 um/s.
    double const angle = 3 * std::numbers::pi / 180;
    auto simulation = lying(0.1, {g * std::sin(angle), 0, -g * std::cos(angle)}, {});
    auto const steps = static_cast<std::int64_t>(0.2 / simulation.options().time_step);
    simulation.advance(steps);
    double const early = simulation.read(dem::Fields::all).position(0).x;
    simulation.advance(4 * steps);
    EXPECT_NEAR(simulation.read(dem::Fields::all).position(0).x, early, 1e-12);
    EXPECT_LT(std::abs(early), 5e-6);
}

TEST(ConstantTorque, ManyContactsAtOnceBringASphereToRest)
{
    // Between six walls that press on it: all of them meet its own moment of inertia only.
    contact::PairProperties pair;
    pair.static_friction = pair.kinetic_friction = 0;
    pair.rolling = contact::RollingLaw::constant_torque;
    pair.rolling_friction = 0.5;
    dem::Simulation simulation(
        one_material(stone, pair),
        {.time_step = 0.2 * dem::rayleigh_time(r, stone), .gravity = {}, .skin = 0.2 * r});
    double const near = 0.999 * r;
    for (auto const& side : dem::box_sides({-near, -near, -near}, {near, near, near}))
        simulation.add(dem::Wall{.shape = side});
    simulation.add(dem::Body{{}, r, {}, {}, {30, 20, 10}});
    simulation.advance(3000);
    EXPECT_EQ(simulation.counts().wall_contacts, 6u);
    EXPECT_LT(norm(simulation.read(dem::Fields::all).spin(0)), 1e-9);
}

} // namespace
