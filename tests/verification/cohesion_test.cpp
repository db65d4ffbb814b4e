// Cohesion against its closed forms: force over distance, pull-off, where it ends, and what it does to
// friction.
#include "tests/support/pull.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;
using namespace demens::test;
using std::numbers::pi;

constexpr double radius = 1e-4, gamma_s = 0.05, modulus = 1e8;
contact::Material const soft{"soft", 2500, modulus, 0.3};
constexpr double plane_modulus = modulus / (2 * (1 - 0.09)); //!< E* of two such bodies

contact::Model with(contact::CohesionLaw law)
{
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    pair.cohesion = law;
    pair.surface_energy = gamma_s;
    pair.cohesion_energy_density = 1e5;
    pair.surface_tension = 0.072;
    pair.bridge_volume = 1e-15;
    pair.contact_angle_deg = 20;
    return one_material(soft, pair);
}

double hertz(double overlap)
{
    return overlap > 0 ? 4.0 / 3 * plane_modulus * std::sqrt(radius) * std::pow(overlap, 1.5) : 0;
}

//! Two spheres that move apart along x: largest attraction.
double pull_off_of_pair(contact::Model model, double radius_i, double radius_j)
{
    for (auto& material : model.materials)
        material.density = 1e12;
    double const time_step = 1e-6, overlap = 1e-7, path = 4e-6;
    int const steps = 20000;
    dem::Simulation simulation(model, {.time_step = time_step, .gravity = {}, .skin = radius_i});
    simulation.add(dem::Body{{}, radius_i});
    simulation.add(dem::Body{.position = {radius_i + radius_j - overlap, 0, 0},
                             .radius = radius_j,
                             .velocity = {path / (steps * time_step), 0, 0}});
    double largest = 0;
    for (int k = 0; k < steps; ++k) {
        simulation.advance(1);
        auto const now = state_of(simulation);
        for (std::size_t p = 0; p < 2; ++p)
            if (now.id(p).value == 0)
                largest = std::max(largest, now.force(p).x);
    }
    return largest;
}

TEST(Dmt, PullsOffWithFourPiGammaR)
{
    double const expected = 4 * pi * gamma_s * radius;
    auto const model = with(contact::CohesionLaw::dmt);
    EXPECT_NEAR(pull_off(pull(model, radius, 1e-7, -1e-7, 20000)).force, expected, 1e-3 * expected);
    // R* = 2/3 R for radii R and 2 R.
    EXPECT_NEAR(pull_off_of_pair(model, radius, 2 * radius), 2.0 / 3 * expected, 1e-3 * expected);
    for (auto const& point : pull(model, radius, -1e-7, -1e-9, 100))
        EXPECT_EQ(point.force, 0) << point.overlap;
}

TEST(Jkr, PullsOffWithThreePiGammaR)
{
    double const expected = 3 * pi * gamma_s * radius;
    auto const model = with(contact::CohesionLaw::jkr);
    auto const curve = pull(model, radius, 5e-8, -1.5e-7, 40000);
    auto const end = pull_off(curve);
    EXPECT_NEAR(end.force, expected, 1e-6 * expected);
    EXPECT_NEAR(pull_off_of_pair(model, radius, 2 * radius), 2.0 / 3 * expected, 1e-4 * expected);
    // 8/9 of it at zero overlap; it ends at the gap 3 a^2/R, a^3 = pi gamma R^2/(4 E*), with 5/9 of it.
    double const a = std::cbrt(pi * gamma_s * radius * radius / (4 * plane_modulus));
    EXPECT_NEAR(end.gap, 3 * a * a / radius, 1e-11);
    double at_zero = 0, last = 0;
    for (auto const& point : curve) {
        at_zero = point.overlap > 0 ? point.force : at_zero;
        last = point.force < 0 ? point.force : last;
    }
    EXPECT_NEAR(-at_zero, 8.0 / 9 * expected, 1e-4 * expected);
    EXPECT_NEAR(-last, 5.0 / 9 * expected, 0.02 * expected); // the curve ends vertically
}

TEST(Jkr, FollowsTheImplicitCurve)
{
    // d = a^2/R - 2 sqrt(pi gamma a/E*), F = 4 E* a^3/(3 R) - 4 sqrt(pi gamma E* a^3), for contact radii a
    // above that of separation.
    for (auto const& point : pull(with(contact::CohesionLaw::jkr), radius, 1e-5, -1e-7, 50)) {
        double const smallest = std::cbrt(pi * gamma_s * radius * radius / (4 * plane_modulus));
        double low = smallest, high = radius;
        for (int k = 0; k < 200; ++k) {
            double const a = 0.5 * (low + high);
            double const d = a * a / radius - 2 * std::sqrt(pi * gamma_s * a / plane_modulus);
            (d < point.overlap ? low : high) = a;
        }
        double const expected = 4 * plane_modulus * low * low * low / (3 * radius) -
                                4 * std::sqrt(pi * gamma_s * plane_modulus * low * low * low);
        EXPECT_NEAR(point.force, expected, 1e-9 * (std::abs(expected) + pi * gamma_s * radius))
            << point.overlap;
    }
}

TEST(Jkr, DoesNotActBeforeContactAndNotAfterSeparation)
{
    auto const model = with(contact::CohesionLaw::jkr);
    for (auto const& point : pull(model, radius, -3e-6, -1e-9, 1000))
        EXPECT_EQ(point.force, 0) << point.overlap;
}

TEST(VanDerWaals, FollowsTheFormulaThroughTheGapToItsCutOff)
{
    auto model = with(contact::CohesionLaw::van_der_waals);
    double const hamaker = 40e-20; // the default
    model.pairs[0].surface_energy = 1e-4;
    double const contact_force = 4 * pi * 1e-4 * radius;
    double const g0 = std::sqrt(hamaker * radius / (6 * contact_force)), last = 10 * g0;
    EXPECT_NEAR(g0, 7.2838e-9, 1e-12);
    int far = 0, near = 0, beyond = 0;
    for (auto const& [from, to] : {std::pair{-12 * g0, g0}, std::pair{g0, -12 * g0}})
        for (auto const& point : pull(model, radius, from, to, 4000)) {
            double const gap = -point.overlap;
            if (std::abs(gap - last) < 1e-3 * g0)
                continue;
            double const attraction = gap > last ? 0
                                      : gap > g0 ? hamaker * radius / (6 * gap * gap)
                                                 : contact_force;
            EXPECT_NEAR(point.force, hertz(point.overlap) - attraction, 1e-9 * contact_force) << gap;
            ++(gap > last ? beyond : gap > g0 ? far : near);
        }
    EXPECT_GT(far, 4000);
    EXPECT_GT(near, 500);
    EXPECT_GT(beyond, 500);
}

TEST(Capillary, BridgeFormsAtContactAndLastsToItsRuptureDistance)
{
    auto const model = with(contact::CohesionLaw::capillary);
    double const angle = 20 * pi / 180, rupture = (1 + 0.5 * angle) * 1e-5;
    for (auto const& point : pull(model, radius, -1.5 * rupture, -1e-9, 500))
        EXPECT_EQ(point.force, 0) << point.overlap;
    auto const curve = pull(model, radius, 1e-9, -1.5 * rupture, 10000);
    for (auto const& point : curve) {
        // Willett et al. (2000) for spheres of radius 2 R*, which is 2 R on a plane.
        double const gap = std::max(-point.overlap, 0.0), s = gap * std::sqrt(2 * radius / 1e-15);
        double const bridge = 4 * pi * radius * 0.072 * std::cos(angle) / (1 + 1.05 * s + 2.5 * s * s);
        double const expected = hertz(point.overlap) - (gap < rupture ? bridge : 0);
        EXPECT_NEAR(point.force, expected, 1e-12) << point.overlap;
    }
    EXPECT_NEAR(pull_off(curve).gap, rupture, 2e-9);
}

TEST(LinearCohesion, IsProportionalToTheArea)
{
    for (auto const& point : pull(with(contact::CohesionLaw::linear_cohesion), radius, 2e-6, 1e-9, 50)) {
        double const area = pi * point.overlap * (2 * radius - point.overlap); // circle of sphere and plane
        EXPECT_NEAR(point.force, hertz(point.overlap) - 1e5 * area, 1e-9 * 1e5 * area) << point.overlap;
    }
    for (auto const& point : pull(with(contact::CohesionLaw::sjkr2), radius, 2e-6, 1e-9, 50)) {
        double const area = 4 * pi * point.overlap * radius;
        EXPECT_NEAR(point.force, hertz(point.overlap) - 1e5 * area, 1e-9 * 1e5 * area) << point.overlap;
    }
}

TEST(LinearCohesion, TakesTheLensOfTwoUnequalSpheres)
{
    // Two spheres of radii r and R at distance c cut each other in a circle of radius a,
    // 4 c^2 a^2 = 4 c^2 R^2 - (c^2 - r^2 + R^2)^2.
    auto model = with(contact::CohesionLaw::linear_cohesion);
    double const r = radius, R = 3 * radius, c = r + R - 5e-6;
    double const square = R * R - std::pow((c * c - r * r + R * R) / (2 * c), 2);
    dem::Simulation simulation(model, {.time_step = 1e-15, .gravity = {}, .skin = radius});
    simulation.add(dem::Body{{}, R});
    simulation.add(dem::Body{{c, 0, 0}, r});
    simulation.advance(1);
    double const effective = r * R / (r + R);
    double const repulsion = 4.0 / 3 * plane_modulus * std::sqrt(effective) * std::pow(5e-6, 1.5);
    EXPECT_NEAR(std::abs(state_of(simulation).force(0).x), std::abs(repulsion - 1e5 * pi * square),
                1e-6 * repulsion);
}

TEST(CohesionInLimit, DecidesWhetherAdhesionRaisesFriction)
{
    // A sphere that is pulled onto the plane by gravity and adhesion slides without rotation (an enormous
    // rolling resistance): it is braked by mu (m g + F_c), or by mu m g where the limit contains the
    // attraction.
    double const mu = 0.3, mass = 2500 * 4.0 / 3 * pi * std::pow(radius, 3), g = 9.81;
    double const adhesion = 0.5 * mass * g;
    for (bool const in_limit : {false, true}) {
        auto model = with(contact::CohesionLaw::dmt);
        auto& pair = model.pairs[0];
        pair.restitution = 0.3;
        pair.static_friction = pair.kinetic_friction = mu;
        pair.rolling = contact::RollingLaw::epsd2;
        pair.rolling_friction = 100;
        pair.surface_energy = adhesion / (4 * pi * radius);
        pair.cohesion_in_limit = in_limit;
        double const overlap =
            std::pow(0.75 * (mass * g + adhesion) / (plane_modulus * std::sqrt(radius)), 2.0 / 3);
        dem::Simulation simulation(model, {.time_step = 1e-7, .skin = radius});
        simulation.add(
            dem::Body{.position = {0, 0, radius - overlap}, .radius = radius, .velocity = {0.1, 0, 0}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        simulation.advance(20000);
        double const braking = mu * (in_limit ? 1.0 : 1.5) * g * simulation.time();
        EXPECT_NEAR(0.1 - state_of(simulation).velocity(0).x, braking, 0.01 * braking) << in_limit;
    }
}

} // namespace
