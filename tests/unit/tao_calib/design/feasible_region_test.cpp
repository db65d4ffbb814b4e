#include "demens/base/error.hpp"
#include "tao_calib/design/design.hpp"
#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/design/feasible_region.hpp"
#include "tao_calib/unit_cube.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ensemble::Factor;
using ensemble::LinearConstraint;

std::vector<Factor> const frictions = {{"ms", "ms", 0.1, 1.0}, {"mk", "mk", 0.05, 1.0}};
LinearConstraint const kinetic_below_static = {"mk <= ms", {-1, 1}, 0};

TEST(LinearMaximum, IsThatOfATextbook)
{
    // Maximise 3 x + 5 y with x <= 4, 2 y <= 12, 3 x + 2 y <= 18: 36 at (2, 6) (Hillier and Lieberman).
    VectorXd const found =
        linear_maximum(MatrixXd{{1, 0}, {0, 2}, {3, 2}}, VectorXd{{4, 12, 18}}, VectorXd{{3, 5}});
    EXPECT_NEAR(found[0], 2, 1e-12);
    EXPECT_NEAR(found[1], 6, 1e-12);
}

TEST(LinearMaximum, EndsWhereTheSimplexMethodCanCycle)
{
    // Beale's example: 0.05 at (1/25, 0, 1, 0).
    MatrixXd const A{{0.25, -60, -1.0 / 25, 9}, {0.5, -90, -1.0 / 50, 3}, {0, 0, 1, 0}};
    VectorXd const c{{0.75, -150, 0.02, -6}};
    EXPECT_NEAR(c.dot(linear_maximum(A, VectorXd{{0, 0, 1}}, c)), 0.05, 1e-12);
}

TEST(FeasibleRegion, HasTheLargestBallInside)
{
    // The triangle y <= x of the unit square: radius 1/(2 + sqrt(2)), centre at (1 - r, r).
    std::vector<Factor> const unit{{"x", "x", 0, 1}, {"y", "y", 0, 1}};
    FeasibleRegion const triangle(unit, {{"y <= x", {-1, 1}, 0}});
    double const radius = 1 / (2 + std::sqrt(2.0));
    EXPECT_NEAR(triangle.radius(), radius, 1e-12);
    EXPECT_NEAR(triangle.centre()[0], 1 - radius, 1e-12);
    EXPECT_NEAR(triangle.centre()[1], radius, 1e-12);
    EXPECT_FALSE(triangle.is_flat());
    EXPECT_TRUE(FeasibleRegion(unit, {{"x + y >= 2.1", {-1, -1}, -2.1}}).is_empty());
    FeasibleRegion const corner(unit, {{"x + y >= 2", {-1, -1}, -2}});
    EXPECT_FALSE(corner.is_empty());
    EXPECT_TRUE(corner.is_flat());
}

TEST(FactorSpace, FindsASmallCorner)
{
    // ms + mk >= 1.9999: a triangle of 1e-4 by 1e-4 at (1, 1).
    FactorSpace const space(frictions, {kinetic_below_static, {"ms + mk >= 1.9999", {-1, -1}, -1.9999}});
    RandomStream random(1);
    VectorXd least = VectorXd::Constant(2, 2), most = VectorXd::Zero(2);
    for (int i = 0; i < 200; ++i) {
        VectorXd const values = space.own_units(space.sample(random));
        ASSERT_TRUE(space.feasible(values)) << values.transpose();
        least = least.cwiseMin(values), most = most.cwiseMax(values);
    }
    // The corners are (0.99995, 0.99995), (1, 0.9999) and (1, 1).
    EXPECT_NEAR(least[0], 0.99995, 1e-5);
    EXPECT_NEAR(least[1], 0.9999, 2e-5);
    EXPECT_GT(most[1], 1 - 2e-5);
}

TEST(FactorSpace, DrawsEvenlyFromATightBox)
{
    // ms 0.1 to 0.105, mk 0.05 to 0.055, 3e-5 of the range: means in the middle, variances of a uniform one.
    FactorSpace const space(
        frictions, {kinetic_below_static, {"ms <= 0.105", {1, 0}, 0.105}, {"mk <= 0.055", {0, 1}, 0.055}});
    RandomStream random(2);
    constexpr int draws = 2000;
    MatrixXd values(draws, 2);
    for (int i = 0; i < draws; ++i)
        values.row(i) = space.own_units(space.sample(random)).transpose();
    double const sd = 0.005 / std::sqrt(12.0);
    for (int k = 0; k < 2; ++k) {
        double const middle = k == 0 ? 0.1025 : 0.0525;
        EXPECT_NEAR(values.col(k).mean(), middle, 4 * sd / std::sqrt(draws));
        EXPECT_NEAR(std::sqrt((values.col(k).array() - values.col(k).mean()).square().mean()), sd, 0.05 * sd);
    }
}

TEST(FactorSpace, DrawsEvenlyFromAThinBand)
{
    // ms - 1e-5 <= mk <= ms: along the band, ms is uniform between 0.1 and 1.
    FactorSpace const space(frictions, {kinetic_below_static, {"mk >= ms - 1e-5", {1, -1}, 1e-5}});
    RandomStream random(3);
    constexpr int draws = 1000;
    VectorXd values(draws);
    for (double& value : values)
        value = space.own_units(space.sample(random))[0];
    double const sd = 0.9 / std::sqrt(12.0);
    EXPECT_NEAR(values.mean(), 0.55, 4 * sd / std::sqrt(draws));
    EXPECT_NEAR(std::sqrt((values.array() - values.mean()).square().mean()), sd, 0.06 * sd);
}

TEST(FactorSpace, SaysWhyThereIsNoRoom)
{
    auto message = [](std::vector<Factor> const& factors, std::vector<LinearConstraint> const& constraints) {
        try {
            FactorSpace const space(factors, constraints);
        } catch (InputError const& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message(frictions, {{"ms + mk >= 2.01", {-1, -1}, -2.01}}).find("no point within the bounds"),
              std::string::npos);
    // An equality in two halves leaves a line.
    EXPECT_NE(message(frictions, {kinetic_below_static, {"mk >= ms", {1, -1}, 0}}).find("leave no room"),
              std::string::npos);
    // Between the levels there is room, on them there is none.
    std::vector<Factor> const levels{{"a", "a", 0, 4, false, {0, 2, 4}}, {"b", "b", 0, 1}};
    EXPECT_NE(message(levels, {{"a + 0.1 b <= 1.5", {1, 0.1}, 1.5}, {"a >= 0.5", {-1, 0}, -0.5}})
                  .find("no point on the levels"),
              std::string::npos);
    EXPECT_EQ(message(levels, {{"a + 0.0001 b >= 4.00009", {-1, -0.0001}, -4.00009}}), "");
}

TEST(Designs, EveryKindThatFillsFindsASmallCorner)
{
    for (auto const kind : {ensemble::DesignKind::latin_hypercube, ensemble::DesignKind::sobol}) {
        ensemble::DesignOptions options;
        options.kind = kind;
        options.points = 8;
        std::vector<LinearConstraint> const constraints{kinetic_below_static,
                                                        {"ms + mk >= 1.9999", {-1, -1}, -1.9999}};
        auto const points = make_design(options, frictions, constraints, 1);
        FactorSpace const space(frictions, constraints);
        ASSERT_EQ(points.rows(), 8);
        for (int i = 0; i < 8; ++i)
            EXPECT_TRUE(space.feasible(points.row(i).transpose())) << points.row(i);
    }
}

TEST(UnitCube, DrawsAndProjectsIntoASmallCorner)
{
    UnitCube const cube(frictions, {kinetic_below_static, {"ms + mk >= 1.9999", {-1, -1}, -1.9999}});
    RandomStream random(4);
    VectorXd first = cube.sample(random);
    int different = 0;
    for (int i = 0; i < 50; ++i) {
        VectorXd const unit = cube.sample(random);
        EXPECT_TRUE(cube.feasible(cube.to_values(unit)));
        different += unit != first;
        VectorXd const anywhere{{random.uniform(), random.uniform()}};
        EXPECT_TRUE(cube.feasible(cube.to_values(cube.project(anywhere))));
    }
    EXPECT_EQ(different, 50);
}

TEST(FactorSpace, TwentyFiveFactorsWithAChainOfConstraints)
{
    // x1 <= x2 <= ... <= x25: one in 25! of the cube.
    std::vector<Factor> factors;
    std::vector<LinearConstraint> constraints;
    for (int k = 0; k < 25; ++k) {
        auto const name = std::to_string(k);
        factors.push_back({name, name, 0, 1});
    }
    for (std::size_t k = 0; k + 1 < 25; ++k) {
        LinearConstraint constraint{"chain", std::vector<double>(25), 0};
        constraint.coefficients[k] = 1, constraint.coefficients[k + 1] = -1;
        constraints.push_back(constraint);
    }
    FactorSpace const space(factors, constraints);
    RandomStream random(5);
    for (int i = 0; i < 20; ++i) {
        VectorXd const values = space.own_units(space.sample(random));
        EXPECT_TRUE(space.feasible(values));
    }
}

} // namespace
} // namespace demens::tao_calib
