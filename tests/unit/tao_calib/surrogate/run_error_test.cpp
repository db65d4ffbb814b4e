#include "tao_calib/surrogate/run_error.hpp"

#include "tao_calib/surrogate/polynomial.hpp"
#include "tao_calib/surrogate/radial_basis.hpp"
#include "tests/unit/tao_calib/surrogate/samples.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(RunError, OfAMeanIsTheSampleDeviation)
{
    // Of 1, 2, 3, 6: sqrt(14/3) with 3 degrees of freedom. What is left out differs by 4/3 as much from the
    // others' mean, which adds a third of a variance of its own.
    VectorXd const values{{1, 2, 3, 6}};
    MatrixXd const operation = MatrixXd::Constant(4, 4, -1.0 / 3) + 4.0 / 3 * MatrixXd::Identity(4, 4);
    auto const error = run_error(operation * values, operation, VectorXd::Ones(4));
    EXPECT_NEAR(error.sd, std::sqrt(14.0 / 3), 1e-14);
    EXPECT_NEAR(error.degrees_of_freedom, 3, 1e-12);
}

TEST(RunError, OfLeastSquaresIsTheSameBothWays)
{
    // A line through six places, means over different numbers of runs: by leverages, and by the whole
    // operation.
    MatrixXd rows(6, 2);
    rows << 1, 0, 1, 0.1, 1, 0.4, 1, 0.5, 1, 0.9, 1, 1;
    VectorXd const values{{0.3, 0.1, 0.9, 0.8, 2.1, 1.7}}, weights{{1, 3, 2, 1, 5, 2}};
    MatrixXd const hat = rows * (rows.transpose() * weights.asDiagonal() * rows).inverse() *
                         rows.transpose() * weights.asDiagonal();
    VectorXd const own = (1 - hat.diagonal().array()).inverse();
    MatrixXd const operation = own.asDiagonal() * (MatrixXd::Identity(6, 6) - hat);
    VectorXd const errors = operation * values;
    auto const general = run_error(errors, operation, weights),
               simple = run_error_of_regression(errors, hat.diagonal(), weights, 2);
    EXPECT_NEAR(general.sd, simple.sd, 1e-13);
    EXPECT_EQ(simple.degrees_of_freedom, 4);
    EXPECT_NEAR(general.degrees_of_freedom, 4, 0.4);
}

TEST(RunError, MakesStatedVariancesThoseOfRepeatedFits)
{
    // A plane with scatter of 0.5 at 12 places, over and over: how much predictions scatter about the truth,
    // and the mean variance that is stated. Leave-one-out errors as they are would state a third to a half
    // too much.
    auto const plane = [](VectorXd const& x) { return 1 + x[0] - 2 * x[1]; };
    VectorXd const point{{0.3, 0.8}};
    RandomStream random(5);
    constexpr int times = 2000;
    double line_error = 0, line_stated = 0, spline_error = 0, spline_stated = 0, line_left_out = 0;
    for (int i = 0; i < times; ++i) {
        auto samples = sampled(12, 2, plane);
        for (double& value : samples.values)
            value += 0.5 * normal(random);
        Polynomial const line(SurrogateKind::linear, samples);
        RadialBasis const spline(samples, 0.3);
        line_error += std::pow(line.value(point) - plane(point), 2) / times;
        line_stated += std::pow(line.standard_deviation(point), 2) / times;
        line_left_out += std::pow(leave_one_out_rmse(line, samples), 2) / times;
        spline_error += std::pow(spline.value(point) - plane(point), 2) / times;
        spline_stated += std::pow(spline.standard_deviation(point), 2) / times;
    }
    EXPECT_NEAR(line_stated / line_error, 1, 0.1);
    EXPECT_NEAR(spline_stated / spline_error, 1, 0.1);
    EXPECT_GT(line_left_out, 1.25 * 0.5 * 0.5);
}

} // namespace
} // namespace demens::tao_calib
