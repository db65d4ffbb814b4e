// Terms that add to any cohesion: each against its formula, their sum, and nothing where all amplitudes are
// 0.
#include "tests/support/motion.hpp"
#include "tests/support/pull.hpp"
#include "tests/support/small_bed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;
using namespace demens::test;
using std::numbers::pi;

constexpr double radius = 1e-4;
contact::Material const soft{"soft", 2500, 1e8, 0.3};
constexpr double plane_modulus = 1e8 / (2 * (1 - 0.09)); //!< E* of two such bodies

contact::PairProperties smooth()
{
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    return pair;
}

//! What the force is more than Hertz's [N].
double beyond_hertz(PullPoint const& point)
{
    double const d = std::max(point.overlap, 0.0);
    return point.force - 4.0 / 3 * plane_modulus * std::sqrt(radius) * std::pow(d, 1.5);
}

std::vector<PullPoint> pull(contact::PairProperties const& pair, double from, double to)
{
    return demens::test::pull(one_material(soft, pair), radius, from, to, 2000);
}

TEST(AddedTerms, AreaPullsInProportionToTheCircle)
{
    auto pair = smooth();
    pair.added_energy_density = 1e5;
    for (auto const& point : pull(pair, 2e-6, -1e-6)) {
        double const d = std::max(point.overlap, 0.0), area = pi * d * (2 * radius - d);
        EXPECT_NEAR(beyond_hertz(point), -1e5 * area, 1e-9 * 1e5 * area) << d;
    }
}

TEST(AddedTerms, SurfacePullsWithFourPiGammaRInContact)
{
    auto pair = smooth();
    pair.added_surface_energy = 0.05;
    double const whole = 4 * pi * 0.05 * radius;
    for (auto const& point : pull(pair, 1e-7, -1e-7))
        EXPECT_NEAR(beyond_hertz(point), point.overlap > 0 ? -whole : 0, 1e-9 * whole) << point.overlap;
}

TEST(AddedTerms, SurfaceWithAGapIsVanDerWaals)
{
    // F = -A R/(6 g^2) with A = 24 pi gamma g_0^2, to 10 g_0.
    double const nearest = 1e-7, hamaker = 24 * pi * 0.05 * nearest * nearest;
    auto pair = smooth();
    pair.added_surface_energy = 0.05;
    pair.added_surface_gap = nearest;
    double const whole = 4 * pi * 0.05 * radius;
    for (auto const& [from, to] : {std::pair{-12e-7, 1e-7}, std::pair{1e-7, -12e-7}})
        for (auto const& point : pull(pair, from, to)) {
            double const gap = -point.overlap;
            if (std::abs(gap - 10 * nearest) < 1e-3 * nearest)
                continue;
            double const attraction = gap > 10 * nearest ? 0
                                      : gap > nearest    ? hamaker * radius / (6 * gap * gap)
                                                         : whole;
            EXPECT_NEAR(beyond_hertz(point), -attraction, 1e-9 * whole) << gap;
        }
}

TEST(AddedTerms, BridgeFormsAtContactAndHoldsToItsRupture)
{
    auto pair = smooth();
    pair.added_surface_tension = 0.072;
    pair.added_bridge_volume = 1e-3;
    double const volume = 1e-3 * std::pow(radius, 3), rupture = std::cbrt(volume);
    for (auto const& point : pull(pair, -1.5 * rupture, -1e-9))
        EXPECT_EQ(point.force, 0) << point.overlap;
    for (auto const& point : pull(pair, 1e-9, -1.5 * rupture)) {
        double const gap = std::max(-point.overlap, 0.0), s = gap * std::sqrt(2 * radius / volume);
        double const bridge = gap < rupture ? 4 * pi * radius * 0.072 / (1 + 1.05 * s + 2.5 * s * s) : 0;
        EXPECT_NEAR(beyond_hertz(point), -bridge, 1e-12) << point.overlap;
    }
}

TEST(AddedTerms, ChargesPushOrPullAsCoulombHasIt)
{
    // q = 4 pi R^2 s of charge s per area; q^2/(4 pi epsilon_0 r^2) with r from centre to centre.
    double const per_area = 1e-5, electric_constant = 8.8541878128e-12;
    double const q = 4 * pi * radius * radius * per_area;
    for (double const sign : {1.0, -1.0}) {
        auto pair = smooth();
        pair.added_charge_pressure = sign * per_area * per_area / (2 * electric_constant);
        pair.added_charge_reach = 1;
        double const scale = q * q / (4 * pi * electric_constant);
        double const at_end = scale / (9 * radius * radius); // on a plane the reach is a radius
        for (auto const& point : pull(pair, -1.2 * radius, 1e-7)) {
            double const r = 2 * radius - point.overlap;
            double const expected = r < 3 * radius ? sign * (scale / (r * r) - at_end) : 0;
            EXPECT_NEAR(beyond_hertz(point), expected, 1e-9 * scale / (radius * radius)) << point.overlap;
        }
    }
}

//! All terms, each with the given share of its usual amplitude, beside a cohesion law.
contact::PairProperties with_terms(contact::CohesionLaw law, double share)
{
    contact::PairProperties pair;
    pair.cohesion = law;
    pair.rolling = contact::RollingLaw::epsd2;
    pair.rolling_friction = 0.1;
    pair.cohesion_energy_density = 2e4;
    pair.surface_energy = 0.05;
    pair.surface_tension = 0.05;
    pair.bridge_volume = 1e-15;
    pair.added_energy_density = share * 1e4;
    pair.added_surface_energy = share * 0.02;
    pair.added_surface_gap = 1e-7;
    pair.added_surface_tension = share * 0.03;
    pair.added_bridge_volume = 0.03;
    pair.added_charge_pressure = share * 10;
    pair.added_charge_reach = 0.2;
    return pair;
}

TEST(AddedTerms, AddToEachOtherAndToTheLawOfThePair)
{
    double const overlap = 3e-7;
    auto const force = [&](contact::PairProperties pair) {
        pair.restitution = 1;
        return pull(pair, overlap, overlap).front().force;
    };
    using contact::CohesionLaw;
    for (auto const law : {CohesionLaw::none, CohesionLaw::dmt, CohesionLaw::jkr, CohesionLaw::capillary}) {
        double const named = force(with_terms(law, 0)), all = force(with_terms(law, 1));
        double sum = 0;
        for (auto const term :
             {&contact::PairProperties::added_energy_density, &contact::PairProperties::added_surface_energy,
              &contact::PairProperties::added_surface_tension,
              &contact::PairProperties::added_charge_pressure}) {
            auto pair = with_terms(law, 0);
            pair.*term = with_terms(law, 1).*term;
            double const change = force(pair) - named;
            EXPECT_GT(std::abs(change), 1e-9) << "a term does nothing";
            sum += change;
        }
        EXPECT_NEAR(all - named, sum, 1e-12 * (std::abs(all) + std::abs(named)));
        // Continuous from nothing.
        EXPECT_NEAR(force(with_terms(law, 1e-9)) - named, 1e-9 * (all - named), 1e-13 * std::abs(named));
    }
}

TEST(AddedTerms, WithoutAmplitudeMotionsAreBitForBitThoseOfTheLawAlone)
{
    auto const bed = [](contact::PairProperties const& pair) {
        auto simulation = small_bed(soft, pair, radius);
        simulation.advance(500);
        return simulation;
    };
    using contact::CohesionLaw;
    for (auto const law :
         {CohesionLaw::none, CohesionLaw::linear_cohesion, CohesionLaw::sjkr2, CohesionLaw::van_der_waals,
          CohesionLaw::dmt, CohesionLaw::jkr, CohesionLaw::capillary}) {
        auto const defaults = contact::PairProperties{};
        auto alone = with_terms(law, 0);
        alone.added_surface_gap = defaults.added_surface_gap;
        alone.added_bridge_volume = defaults.added_bridge_volume;
        alone.added_charge_reach = defaults.added_charge_reach;
        auto without = bed(alone), zero = bed(with_terms(law, 0)), with = bed(with_terms(law, 1e-3));
        EXPECT_TRUE(same_motion(without, zero));
        EXPECT_FALSE(same_motion(without, with));
    }
}

} // namespace
