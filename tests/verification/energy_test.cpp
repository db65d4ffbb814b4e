// The energy ledger closes: every change of energy is accounted for, at the default time step.
#include "demens/base/random.hpp"
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double radius = 5e-3, g = 9.81;
contact::Material const grain{"grain", 2500, 1e7, 0.3};
double const time_step = 0.2 * dem::rayleigh_time(0.9 * radius, grain); // the default

contact::PairProperties usual()
{
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.static_friction = 0.5;
    pair.kinetic_friction = 0.4;
    pair.rolling = contact::RollingLaw::epsd2;
    pair.rolling_friction = 0.1;
    pair.rolling_damping = 0.3;
    pair.rolling_viscosity = 1e-3;
    pair.cohesion_energy_density = 2e4;
    pair.surface_energy = 0.05;
    pair.surface_tension = 0.05;
    pair.bridge_volume = 1e-9;
    return pair;
}

void add_rain(dem::Simulation& simulation, int across, int layers, Vector3 const& corner)
{
    RandomStream random(3);
    for (int k = 0; k < across * across * layers; ++k)
        simulation.add(dem::Body{
            .position =
                corner + Vector3{2.1 * radius * (0.5 + k % across) + 0.1 * radius * random.uniform(),
                                 2.1 * radius * (0.5 + k / across % across) + 0.1 * radius * random.uniform(),
                                 2.1 * radius * (0.6 + k / (across * across))},
            .radius = random.uniform(0.9, 1.0) * radius,
            .velocity = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0}});
}

void add_sides(dem::Simulation& simulation, double side)
{
    auto const wall = [&](Vector3 centre, Vector3 u, Vector3 v) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{centre, u, v, 1, 1}});
    };
    wall({}, {1, 0, 0}, {0, 1, 0});
    wall({}, {0, 1, 0}, {0, 0, 1}), wall({side, 0, 0}, {0, 1, 0}, {0, 0, 1});
    wall({}, {0, 0, 1}, {1, 0, 0}), wall({0, side, 0}, {0, 0, 1}, {1, 0, 0});
}

//! A box into which spheres fall and come to rest.
dem::Simulation settling_box(contact::PairProperties const& pair, bool ledger = true)
{
    dem::Simulation simulation(one_material(grain, pair),
                               {.time_step = time_step, .skin = 0.3 * radius, .energy_ledger = ledger});
    add_rain(simulation, 4, 6, {});
    add_sides(simulation, 4.1 * 2.1 * radius);
    return simulation;
}

TEST(Energy, ElasticImpactGivesBackWhatItTook)
{
    // Without losses the elastic energy is what the kinetic energy lacks; all is there again after it. The
    // impact takes 14 steps: while it lasts, what the step misses of the curved force shows.
    auto pair = usual();
    pair.restitution = 1;
    pair.rolling = contact::RollingLaw::none;
    pair.static_friction = pair.kinetic_friction = 0;
    dem::Simulation simulation(
        one_material(grain, pair),
        {.time_step = time_step, .gravity = {}, .skin = radius, .energy_ledger = true});
    simulation.add(dem::Body{.position = {0, 0, radius * 1.01}, .radius = radius, .velocity = {0.3, 0, -1}});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    double const kinetic = 0.5 * 2500 * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
    double most_elastic = 0;
    for (int k = 0; k < 300; ++k) {
        simulation.advance(1);
        auto const energy = simulation.energy();
        most_elastic = std::max(most_elastic, energy.elastic_normal);
        EXPECT_NEAR(energy.closure_error(), 0, 1e-2) << k;
        EXPECT_EQ(energy.lost(), 0) << k;
    }
    EXPECT_NEAR(most_elastic, kinetic, 0.01 * kinetic); // all of 1 m/s, none of the 0.3 along the plane
    EXPECT_NEAR(simulation.energy().closure_error(), 0, 1e-3);
    EXPECT_NEAR(simulation.energy().kinetic(), kinetic * 1.09, 2e-3 * kinetic);
}

TEST(Energy, LossesAreThoseOfTheRebound)
{
    // Normal: 1 - e^2 of m/2 v^2 goes to damping. A sliding impact: friction takes mu (1 + e) m v_n times the
    // mean slip speed, v_t - 7/4 mu (1 + e) v_n.
    double const e = 0.5, mu = 0.2, vn = 1, vt = 5;
    auto pair = usual();
    pair.restitution = e;
    pair.static_friction = pair.kinetic_friction = mu;
    pair.rolling = contact::RollingLaw::none;
    dem::Simulation simulation(
        one_material(grain, pair),
        {.time_step = 0.05 * time_step, .gravity = {}, .skin = radius, .energy_ledger = true});
    simulation.add(dem::Body{.position = {0, 0, radius * 1.01}, .radius = radius, .velocity = {vt, 0, -vn}});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.advance(6000);
    double const mass = 2500 * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
    auto const energy = simulation.energy();
    EXPECT_GT(state_of(simulation).velocity(0).z, 0);
    double const damped = 0.5 * mass * (1 - e * e) * vn * vn;
    double const rubbed = mu * (1 + e) * mass * vn * (vt - 1.75 * mu * (1 + e) * vn);
    EXPECT_NEAR(energy.lost_to_damping, damped, 0.005 * damped);
    EXPECT_NEAR(energy.lost_to_friction, rubbed, 0.005 * rubbed);
    EXPECT_NEAR(energy.elastic(), 0, 1e-12);
    EXPECT_NEAR(energy.closure_error(), 0, 1e-4);
}

TEST(Energy, ClosesInASettlingBoxForEveryLaw)
{
    using contact::CohesionLaw, contact::NormalLaw, contact::RollingLaw, contact::TangentialLaw;
    for (auto const& [normal, tangential, rolling, cohesion] :
         {std::tuple{NormalLaw::hertz, TangentialLaw::mindlin_rescale, RollingLaw::epsd2, CohesionLaw::none},
          std::tuple{NormalLaw::hysteretic_spring, TangentialLaw::linear_coulomb, RollingLaw::epsd,
                     CohesionLaw::none},
          std::tuple{NormalLaw::hertz, TangentialLaw::mindlin, RollingLaw::constant_torque,
                     CohesionLaw::linear_cohesion},
          std::tuple{NormalLaw::hertz, TangentialLaw::mindlin_deresiewicz, RollingLaw::viscous,
                     CohesionLaw::sjkr2},
          std::tuple{NormalLaw::hertz, TangentialLaw::mindlin_rescale, RollingLaw::epsd, CohesionLaw::dmt},
          std::tuple{NormalLaw::hertz, TangentialLaw::linear_coulomb, RollingLaw::epsd2, CohesionLaw::jkr},
          std::tuple{NormalLaw::hertz, TangentialLaw::mindlin_rescale, RollingLaw::none,
                     CohesionLaw::capillary},
          std::tuple{NormalLaw::hertz, TangentialLaw::mindlin_rescale, RollingLaw::none,
                     CohesionLaw::van_der_waals}}) {
        auto pair = usual();
        pair.normal = normal;
        pair.tangential = tangential;
        pair.rolling = rolling;
        pair.cohesion = cohesion;
        auto simulation = settling_box(pair);
        double worst = 0;
        for (int k = 0; k < 60; ++k) {
            simulation.advance(100);
            worst = std::max(worst, std::abs(simulation.energy().closure_error()));
        }
        ASSERT_EQ(simulation.health(), dem::Health::good);
        auto const energy = simulation.energy();
        std::string const which =
            std::to_string(static_cast<int>(normal)) + std::to_string(static_cast<int>(tangential)) +
            std::to_string(static_cast<int>(rolling)) + std::to_string(static_cast<int>(cohesion));
        EXPECT_LT(worst, 5e-3) << which;
        EXPECT_LT(energy.kinetic(), 0.02 * energy.turned_over) << which;
    }
}

TEST(Energy, ClosesWithTermsThatAddToCohesion)
{
    auto pair = usual();
    pair.added_energy_density = 5e4;
    pair.added_surface_energy = 0.1;
    pair.added_surface_gap = 2e-5;
    pair.added_surface_tension = 0.15;
    for (double const pressure : {-20.0, 40.0}) {
        pair.added_charge_pressure = pressure;
        auto simulation = settling_box(pair);
        double worst = 0, strongest = 0;
        for (int k = 0; k < 60; ++k) {
            simulation.advance(100);
            auto const energy = simulation.energy();
            worst = std::max(worst, std::abs(energy.closure_error()));
            strongest = std::max(strongest, std::abs(energy.cohesive) / energy.turned_over);
        }
        ASSERT_EQ(simulation.health(), dem::Health::good);
        EXPECT_LT(worst, 5e-3) << pressure;
        EXPECT_GT(strongest, 0.01) << pressure;
    }
}

TEST(Energy, ClosesInATurningDrum)
{
    dem::Simulation simulation(one_material(grain, usual()),
                               {.time_step = time_step, .skin = 0.3 * radius, .energy_ledger = true});
    double const drum = 8 * radius, rate = 6;
    add_rain(simulation, 4, 4, {-4.4 * radius, -4.4 * radius, -5 * radius});
    simulation.add(dem::Wall{.shape = dem::Cylinder{{}, {0, 1, 0}, 1, drum}, .spin = {0, rate, 0}});
    for (double const y : {-4.6 * radius, 4.6 * radius})
        simulation.add(dem::Wall{
            .shape = dem::Disc{{0, y, 0}, {0, 1, 0}, drum}, .spin = {0, rate, 0}, .pivot = {0, y, 0}});
    double worst = 0;
    for (int k = 0; k < 80; ++k) {
        simulation.advance(200);
        worst = std::max(worst, std::abs(simulation.energy().closure_error()));
    }
    ASSERT_EQ(simulation.health(), dem::Health::good);
    auto const energy = simulation.energy();
    EXPECT_LT(worst, 5e-3);
    // The drum drives what is lost, most of it after the particles have fallen.
    EXPECT_GT(energy.work_of_walls, 0.3 * energy.lost());
}

TEST(Energy, WallsThatMoveAndGoAreAccountedFor)
{
    // A lid presses the settled bed and is then taken away at once.
    auto simulation = settling_box(usual());
    simulation.advance(6000);
    double top = 0;
    for (auto const& p : state_of(simulation).places())
        top = std::max(top, p.z + p.radius);
    dem::Wall const lid{.shape = dem::Rectangle{{0, 0, top}, {1, 0, 0}, {0, 1, 0}, 1, 1},
                        .velocity = {0, 0, -0.1}};
    auto const number = simulation.add(lid);
    simulation.advance(1000);
    auto const pressed = simulation.energy();
    EXPECT_GT(pressed.work_of_walls, 0.1 * pressed.turned_over);
    EXPECT_LT(std::abs(pressed.closure_error()), 5e-3);
    simulation.activate(number, false);
    simulation.advance(3000);
    auto const released = simulation.energy();
    EXPECT_LT(released.work_of_walls, pressed.work_of_walls);
    EXPECT_LT(std::abs(released.closure_error()), 5e-3);
}

TEST(Energy, LedgerDoesNotChangeTheMotion)
{
    auto pair = usual();
    pair.cohesion = contact::CohesionLaw::capillary;
    auto with = settling_box(pair), without = settling_box(pair, false);
    with.advance(3000);
    without.advance(3000);
    auto const a = with.read(dem::Fields::places), b = without.read(dem::Fields::places);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a.position(k), b.position(k));
    }
}

} // namespace
