#include "tao_calib/design/design.hpp"
#include "tao_calib/design/latin_hypercube.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

using namespace demens;
using namespace demens::tao_calib;
using ensemble::DesignOptions;
using ensemble::Factor;
using ensemble::LinearConstraint;

namespace {

Factor const static_friction{"contact.static_friction", "static_friction", 0.1, 1.2};
Factor const kinetic_friction{"contact.kinetic_friction", "kinetic_friction", 0.1, 1.2};
LinearConstraint const kinetic_at_most_static{"kinetic_friction <= static_friction", {-1, 1}, 0};

DesignOptions latin_hypercube(int points)
{
    DesignOptions options;
    options.kind = ensemble::DesignKind::latin_hypercube;
    options.points = points;
    return options;
}

} // namespace

// van Dam et al. (2007, Oper. Res. 55:158), maximin Latin hypercubes in two dimensions, Euclidean distance.
TEST(LatinHypercube, SmallestDistanceIsTheKnownBest)
{
    int const best[] = {2, 2, 5, 5, 5, 8, 8};
    for (int points = 2; points <= 8; ++points)
        for (std::uint64_t seed : {1, 2, 3})
            EXPECT_EQ(smallest_squared_distance(maximin_latin_hypercube(points, 2, seed)), best[points - 2])
                << points << " points, seed " << seed;
}

TEST(LatinHypercube, EveryColumnIsAPermutation)
{
    auto const places = maximin_latin_hypercube(17, 4, 5);
    for (int k = 0; k < 4; ++k)
        EXPECT_EQ(std::set<int>(places.col(k).begin(), places.col(k).end()).size(), 17u);
}

TEST(LatinHypercube, VeryManyPointsAreOneTooAndTheirDistancesAreNotLookedAt)
{
    auto const places =
        maximin_latin_hypercube(60000, 3, 1); // squares of their distances are no int any more
    for (int k = 0; k < 3; ++k) {
        std::vector<int> column(places.col(k).begin(), places.col(k).end());
        std::sort(column.begin(), column.end());
        EXPECT_EQ(column.front(), 0);
        EXPECT_EQ(column.back(), 59999);
        EXPECT_EQ(std::unique(column.begin(), column.end()), column.end());
    }
    EXPECT_NE(places.col(0), places.col(1));
}

TEST(LatinHypercube, SpreadsLogarithmicFactorsInTheLogarithm)
{
    Factor modulus{"material.youngs_modulus", "youngs_modulus", 1e6, 1e8, true};
    auto points = make_design(latin_hypercube(4), {modulus}, {}, 1);
    std::sort(points.data(), points.data() + 4);
    // Middles of four strata of equal ratio: 10^6.25, 10^6.75, 10^7.25, 10^7.75.
    EXPECT_NEAR(points(0), 1778279.41, 0.01);
    EXPECT_NEAR(points(1), 5623413.25, 0.01);
    EXPECT_NEAR(points(2), 17782794.10, 0.01);
    EXPECT_NEAR(points(3), 56234132.52, 0.01);
}

TEST(LatinHypercube, DiscreteFactorTakesItsLevelsEquallyOften)
{
    Factor vanes{"rig.vanes", "vanes", 2, 8, false, {2, 4, 8}};
    auto const points = make_design(latin_hypercube(9), {vanes, static_friction}, {}, 1);
    for (double level : vanes.levels)
        EXPECT_EQ((points.col(0).array() == level).count(), 3) << level;
}

TEST(LatinHypercube, ConstraintsHoldAndStrataAreFilled)
{
    int const count = 12;
    auto const design =
        plan_design(latin_hypercube(count), {static_friction, kinetic_friction}, {kinetic_at_most_static}, 3);
    ASSERT_EQ(design.points.rows(), count);
    EXPECT_TRUE((design.points.col(1).array() <= design.points.col(0).array()).all());
    EXPECT_TRUE((design.points.array() >= 0.1).all() && (design.points.array() <= 1.2).all());
    EXPECT_TRUE(design.notes.empty()) << design.notes.front();
    // Over the triangle P(static < s) = ((s - 0.1) / 1.1)^2: twelve equally likely strata, one point each,
    // but for the sampling error of the strata's limits.
    std::set<int> strata;
    for (double s : design.points.col(0))
        strata.insert(static_cast<int>(count * (s - 0.1) * (s - 0.1) / (1.1 * 1.1)));
    EXPECT_GE(strata.size(), 10u);
}

TEST(LatinHypercube, SameSeedSameDesign)
{
    for (auto const& constraints : {std::vector<LinearConstraint>{}, {kinetic_at_most_static}}) {
        auto const make = [&](std::uint64_t seed) {
            return make_design(latin_hypercube(10), {static_friction, kinetic_friction}, constraints, seed);
        };
        EXPECT_EQ(make(7), make(7));
        EXPECT_NE(make(7), make(8));
    }
}

TEST(LatinHypercube, ConstraintThatNothingMeetsIsAnError)
{
    LinearConstraint const impossible{"static_friction <= -1", {1, 0}, -1};
    try {
        make_design(latin_hypercube(5), {static_friction, kinetic_friction}, {impossible}, 1);
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("`static_friction <= -1`"), std::string::npos)
            << error.what();
    }
}
