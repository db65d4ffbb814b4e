#include "tao_calib/solver/bounded_minimum.hpp"
#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/solver/quasi_newton.hpp"
#include "tao_calib/solver/solver_choice.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

//! Rosenbrock's residuals shifted by a target of 1.3, whose minimum in the unit square is at the corner (1,
//! 1).
LeastSquaresProblem rosenbrock(bool with_jacobian = true)
{
    LeastSquaresProblem problem{2, 2, [](VectorXd const& x) {
                                    return VectorXd{{10 * (x[1] - x[0] * x[0]), 1.3 - x[0]}};
                                }};
    if (with_jacobian)
        problem.jacobian = [](VectorXd const& x) { return MatrixXd{{-20 * x[0], 10}, {-1, 0}}; };
    return problem;
}

class EveryKind : public ::testing::TestWithParam<Word<ensemble::SolverKind>>
{
  protected:
    std::unique_ptr<LeastSquaresSolver> solver =
        surrogate_solver(GetParam().value, *PetscEnvironment::session());
};

INSTANTIATE_TEST_SUITE_P(Solver, EveryKind, ::testing::ValuesIn(words_of<ensemble::SolverKind>()),
                         [](auto const& info) { return info.param.text; });

TEST_P(EveryKind, FindsTheMinimumInACornerOfTheCube)
{
    // f = .09 at (1, 1), from one start after the other.
    double best = 1e9;
    VectorXd point;
    for (auto const& start : {VectorXd{{0.2, 0.9}}, VectorXd{{0.7, 0.3}}, VectorXd{{0.5, 0.5}}}) {
        LeastSquaresSettings settings;
        settings.evaluations = 2000;
        auto const result = solver->minimise(rosenbrock(), start, settings);
        EXPECT_GE(result.point.minCoeff(), 0);
        EXPECT_LE(result.point.maxCoeff(), 1);
        EXPECT_NEAR(rosenbrock().evaluate(result.point).squaredNorm(), result.sum_of_squares, 1e-12);
        if (result.sum_of_squares < best)
            best = result.sum_of_squares, point = result.point;
    }
    EXPECT_NEAR(best, 0.09, 1e-4);
    EXPECT_NEAR(point[0], 1, 1e-3);
}

TEST_P(EveryKind, FindsBraninsMinimumFromSeveralStarts)
{
    // Branin as one residual, its root: three minima of .397887.
    LeastSquaresProblem const branin{2, 1, [](VectorXd const& u) {
                                         double const x = 15 * u[0] - 5, y = 15 * u[1];
                                         double const q = y - 5.1 / (4 * pi * pi) * x * x + 5 / pi * x - 6;
                                         return VectorXd{
                                             {std::sqrt(q * q + 10 * (1 - 1 / (8 * pi)) * std::cos(x) + 10)}};
                                     }};
    UnitCube const cube({{"x", "x", 0.0, 1.0}, {"y", "y", 0.0, 1.0}}, {});
    auto const minima = distinct_minima(*solver, branin, cube, spread_points(cube, 6, {}, 1), 0.05);
    EXPECT_NEAR(minima.front().sum_of_squares, 0.397887, 1e-4);
}

TEST_P(EveryKind, MeetsALinearConstraint)
{
    // Nearest point to (0.2, 0.9) with b <= a: (0.55, 0.55), at a squared distance of 0.245.
    UnitCube const cube({{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}}, {{"b <= a", {-1, 1}, 0}});
    LeastSquaresProblem const problem{2, 2, [](VectorXd const& x) {
                                          return VectorXd{{x[0] - 0.2, x[1] - 0.9}};
                                      }};
    auto const minima = distinct_minima(*solver, problem, cube, spread_points(cube, 5, {}, 1), 0.05);
    EXPECT_NEAR(minima[0].sum_of_squares, 0.245, 1e-4);
    EXPECT_TRUE(cube.feasible(cube.to_values(minima[0].point)));
}

TEST_P(EveryKind, GivesTheSameBitsAgain)
{
    auto const first = solver->minimise(rosenbrock(), VectorXd{{0.3, 0.7}}, {});
    auto const second = solver->minimise(rosenbrock(), VectorXd{{0.3, 0.7}}, {});
    EXPECT_EQ(first.point, second.point);
    EXPECT_EQ(first.evaluations, second.evaluations);
}

TEST_P(EveryKind, KeepsFixedFactorsWhereTheyAre)
{
    // (a - 0.2)^2 + (b - 0.9)^2 with b kept at 0.25.
    UnitCube const cube({{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}}, {},
                        {std::numeric_limits<double>::quiet_NaN(), 0.25});
    LeastSquaresProblem const problem{2, 2, [](VectorXd const& x) {
                                          return VectorXd{{x[0] - 0.2, x[1] - 0.9}};
                                      }};
    auto const minima = distinct_minima(*solver, problem, cube, spread_points(cube, 3, {}, 1), 0.05);
    EXPECT_EQ(minima[0].point[1], 0.25);
    EXPECT_NEAR(minima[0].point[0], 0.2, 2e-3);
}

TEST_P(EveryKind, PassesExceptionsOfTheProblemOn)
{
    LeastSquaresProblem const problem{2, 1,
                                      [](VectorXd const&) -> VectorXd { throw std::out_of_range("lost"); }};
    EXPECT_THROW((void)solver->minimise(problem, VectorXd{{0.5, 0.5}}, {}), std::out_of_range);
}

TEST(QuasiNewton, TakesDifferencesWhereThereIsNoJacobian)
{
    VectorXd const point{{0.4, 0.7}};
    auto const residuals = rosenbrock().evaluate(point);
    auto const exact = sum_of_squares_gradient(rosenbrock(), point, residuals);
    // 2 J'r with r = (5.4, 0.9): (2 (-8 5.4 - 0.9), 2 10 5.4).
    EXPECT_NEAR(exact[0], -88.2, 1e-10);
    EXPECT_NEAR(exact[1], 108, 1e-10);
    auto const differences = sum_of_squares_gradient(rosenbrock(false), point, residuals);
    EXPECT_LT((exact - differences).norm(), 1e-6);
}

TEST(Minimise, FindsForrestersMinimum)
{
    // (6x - 2)^2 sin(12x - 4): -6.0207401 at .757249 (Forrester et al. 2008).
    BoundedFunction const forrester{[](VectorXd const& x, VectorXd* slope) {
                                        double const a = 6 * x[0] - 2, b = 12 * x[0] - 4;
                                        if (slope)
                                            *slope =
                                                VectorXd{{12 * a * std::sin(b) + 12 * a * a * std::cos(b)}};
                                        return a * a * std::sin(b);
                                    },
                                    VectorXd::Zero(1), VectorXd::Ones(1)};
    for (auto minimiser :
         {Minimiser::quasi_newton, Minimiser::bobyqa, Minimiser::praxis, Minimiser::simplex}) {
        auto const found = minimise(minimiser, forrester, VectorXd{{0.7}});
        EXPECT_NEAR(found.value, -6.0207401, 1e-6);
        EXPECT_NEAR(found.point[0], 0.757249, 1e-4);
    }
}

} // namespace
} // namespace demens::tao_calib
