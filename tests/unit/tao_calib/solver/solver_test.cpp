#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tests/unit/tao_calib/solver/chwirut1_data.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

Pounders pounders()
{
    return Pounders(*PetscEnvironment::session());
}

//! Rosenbrock's residuals shifted by a target of 1.3: r = (10 (y - x^2), 1.3 - x).
LeastSquaresProblem rosenbrock_problem()
{
    return {2, 2, [](VectorXd const& x) { return VectorXd{{10 * (x[1] - x[0] * x[0]), 1.3 - x[0]}}; }};
}

TEST(Pounders, FitsChwirut1)
{
    // NIST StRD "Chwirut1": y = exp(-b1 x)/(b2 + b3 x), certified values and sum of squares, from NIST's
    // first start.
    VectorXd const upper{{1.0, 0.05, 0.05}};
    LeastSquaresProblem const problem{3, 214, [&](VectorXd const& unit) {
                                          VectorXd const b = unit.cwiseProduct(upper);
                                          VectorXd residuals(214);
                                          for (int i = 0; i < 214; ++i)
                                              residuals[i] =
                                                  chwirut1::y[i] - std::exp(-b[0] * chwirut1::x[i]) /
                                                                       (b[1] + b[2] * chwirut1::x[i]);
                                          return residuals;
                                      }};
    auto const result = pounders().minimise(problem, VectorXd{{0.1, 0.01, 0.02}}.cwiseQuotient(upper), {});
    EXPECT_TRUE(result.converged) << result.ending;
    EXPECT_NEAR(result.sum_of_squares, 2384.4771393, 1e-5);
    VectorXd const b = result.point.cwiseProduct(upper);
    EXPECT_NEAR(b[0], 0.190278, 2e-5);
    EXPECT_NEAR(b[1], 0.00613140, 2e-7);
    EXPECT_NEAR(b[2], 0.0105309, 4e-7);
}

TEST(Pounders, FindsAMinimumInACornerOfTheCube)
{
    for (auto const& start : {VectorXd{{0.2, 0.9}}, VectorXd{{1.0, 0.0}}, VectorXd{{1.0, 1.0}}}) {
        auto const result = pounders().minimise(rosenbrock_problem(), start, {});
        EXPECT_NEAR(result.point[0], 1, 1e-6) << result.ending;
        EXPECT_NEAR(result.point[1], 1, 1e-6);
        EXPECT_NEAR(result.sum_of_squares, 0.09, 1e-7);
        EXPECT_LE(result.point.maxCoeff(), 1.0);
    }
}

TEST(Pounders, ANumberThatIsNoneIsAvoided)
{
    auto problem = rosenbrock_problem();
    problem.evaluate = [inner = problem.evaluate](VectorXd const& x) {
        VectorXd residuals = inner(x);
        if (x[0] < 0.15)
            residuals[0] = std::numeric_limits<double>::quiet_NaN();
        return residuals;
    };
    auto const result = pounders().minimise(problem, VectorXd{{0.2, 0.1}}, {});
    EXPECT_NEAR(result.sum_of_squares, 0.09, 1e-6) << result.ending;
}

TEST(Pounders, EndsAtItsBudgetWithTheBestPoint)
{
    int evaluations = 0;
    double best = std::numeric_limits<double>::infinity();
    auto problem = rosenbrock_problem();
    problem.evaluate = [&, inner = problem.evaluate](VectorXd const& x) {
        ++evaluations;
        VectorXd const residuals = inner(x);
        best = std::min(best, residuals.squaredNorm());
        return residuals;
    };
    LeastSquaresSettings settings;
    settings.evaluations = 7;
    auto const result = pounders().minimise(problem, VectorXd{{0.1, 0.9}}, settings);
    EXPECT_EQ(result.evaluations, evaluations);
    EXPECT_LT(evaluations, 12); // the budget is looked at between iterations
    EXPECT_EQ(result.sum_of_squares, best);
    EXPECT_FALSE(result.converged) << result.ending;
}

TEST(Pounders, PassesExceptionsOfTheProblemOn)
{
    LeastSquaresProblem const problem{1, 1,
                                      [](VectorXd const&) -> VectorXd { throw std::out_of_range("lost"); }};
    EXPECT_THROW((void)pounders().minimise(problem, VectorXd{{0.5}}, {}), std::out_of_range);
    // ... and works again afterwards.
    EXPECT_NEAR(pounders().minimise(rosenbrock_problem(), VectorXd{{0.5, 0.5}}, {}).sum_of_squares, 0.09,
                1e-6);
}

TEST(Pounders, GivesTheSameBitsAgain)
{
    auto const first = pounders().minimise(rosenbrock_problem(), VectorXd{{0.3, 0.7}}, {});
    auto const second = pounders().minimise(rosenbrock_problem(), VectorXd{{0.3, 0.7}}, {});
    EXPECT_EQ(first.point, second.point);
    EXPECT_EQ(first.evaluations, second.evaluations);
}

std::vector<ensemble::Factor> two_factors()
{
    return {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
}

TEST(DistinctMinima, MeetsALinearConstraintExactly)
{
    // Nearest point to (0.2, 0.9) with b <= a: (0.55, 0.55), at a squared distance of 0.245.
    UnitCube const cube(two_factors(), {{"b <= a", {-1, 1}, 0}});
    LeastSquaresProblem const problem{2, 2, [](VectorXd const& x) {
                                          return VectorXd{{x[0] - 0.2, x[1] - 0.9}};
                                      }};
    auto const minima = distinct_minima(pounders(), problem, cube, spread_points(cube, 5, {}, 1), 0.05);
    ASSERT_EQ(minima.size(), 1u);
    EXPECT_NEAR(minima[0].sum_of_squares, 0.245, 1e-7);
    EXPECT_NEAR(minima[0].point[0], 0.55, 1e-4);
    auto const design_point = cube.to_design_point(minima[0].point);
    EXPECT_LE(design_point[1], design_point[0]);
}

TEST(DistinctMinima, FindsAllOfSeveralMinimaBestFirst)
{
    // (x^2 - 1/4)^2 with x = 2u - 1 has minima at u = 1/4 and 3/4; the second residual prefers the latter.
    UnitCube const cube({{"u", "u", 0.0, 1.0}}, {});
    LeastSquaresProblem const problem{1, 2, [](VectorXd const& u) {
                                          double const x = 2 * u[0] - 1;
                                          return VectorXd{{x * x - 0.25, 0.02 * (u[0] - 1)}};
                                      }};
    auto const minima = distinct_minima(pounders(), problem, cube, spread_points(cube, 8, {}, 3), 0.05);
    ASSERT_EQ(minima.size(), 2u);
    EXPECT_NEAR(minima[0].point[0], 0.75, 1e-3);
    EXPECT_NEAR(minima[1].point[0], 0.25, 1e-3);
}

} // namespace
} // namespace demens::tao_calib
