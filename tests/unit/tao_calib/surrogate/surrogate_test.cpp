#include "tao_calib/surrogate/polynomial.hpp"
#include "tao_calib/surrogate/radial_basis.hpp"
#include "tests/unit/tao_calib/surrogate/samples.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(Polynomial, ReproducesALongleyFit)
{
    // NIST StRD "Longley": b0 -3482258.63459582, residual sum of squares 836424.055505915.
    MatrixXd x(16, 6);
    x << 83.0, 234289, 2356, 1590, 107608, 1947, //
        88.5, 259426, 2325, 1456, 108632, 1948,  //
        88.2, 258054, 3682, 1616, 109773, 1949,  //
        89.5, 284599, 3351, 1650, 110929, 1950,  //
        96.2, 328975, 2099, 3099, 112075, 1951,  //
        98.1, 346999, 1932, 3594, 113270, 1952,  //
        99.0, 365385, 1870, 3547, 115094, 1953,  //
        100.0, 363112, 3578, 3350, 116219, 1954, //
        101.2, 397469, 2904, 3048, 117388, 1955, //
        104.6, 419180, 2822, 2857, 118734, 1956, //
        108.4, 442769, 2936, 2798, 120445, 1957, //
        110.8, 444546, 4681, 2637, 121950, 1958, //
        112.6, 482704, 3813, 2552, 123366, 1959, //
        114.2, 502601, 3931, 2514, 125368, 1960, //
        115.7, 518173, 4806, 2572, 127852, 1961, //
        116.9, 554894, 4007, 2827, 130081, 1962;
    VectorXd y(16);
    y << 60323, 61122, 60171, 61187, 63221, 63639, 64989, 63761, 66019, 67857, 68169, 66513, 68655, 69564,
        69331, 70551;
    VectorXd const lower = x.colwise().minCoeff(), range = x.colwise().maxCoeff().transpose() - lower;
    MatrixXd const unit = (x.rowwise() - lower.transpose()).array().rowwise() / range.transpose().array();
    Polynomial const fit(SurrogateKind::linear, {unit, y, VectorXd::Ones(16)});
    EXPECT_NEAR(fit.residual_sum_of_squares(), 836424.055505915, 1e-6);
    VectorXd const origin = -lower.cwiseQuotient(range);
    EXPECT_NEAR(fit.value(origin), -3482258.63459582, 1e-3);
}

TEST(Polynomial, LeaveOneOutErrorsAreThoseOfFitsWithoutThePoint)
{
    auto samples = sampled(15, 3, wavy);
    samples.weights[4] = 3;
    Polynomial const fit(SurrogateKind::quadratic, samples);
    for (int i = 0; i < 15; ++i) {
        Polynomial const rest(SurrogateKind::quadratic, without(samples, i));
        EXPECT_NEAR(fit.leave_one_out_errors()[i],
                    samples.values[i] - rest.value(samples.points.row(i).transpose()), 1e-9);
    }
}

TEST(Polynomial, HasTheGradientOfItsValue)
{
    expect_gradient_matches_differences(Polynomial(SurrogateKind::quadratic, sampled(30, 3, wavy)), 3);
}

TEST(Polynomial, TakesFewerTermsWhereRunsAreFew)
{
    auto const plane = [](VectorXd const& x) { return 1 + 2 * x[0] - x[1] + 0.5 * x[2] * x[2]; };
    EXPECT_EQ(fit_surrogate(SurrogateChoice::quadratic, sampled(30, 3, wavy))->kind(),
              SurrogateKind::quadratic);
    EXPECT_EQ(fit_surrogate(SurrogateChoice::quadratic, sampled(9, 3, plane))->kind(),
              SurrogateKind::linear_and_squares);
    EXPECT_EQ(fit_surrogate(SurrogateChoice::quadratic, sampled(6, 3, plane))->kind(), SurrogateKind::linear);
    EXPECT_EQ(fit_surrogate(SurrogateChoice::quadratic, sampled(3, 3, plane))->kind(),
              SurrogateKind::constant);
    EXPECT_EQ(fit_surrogate(SurrogateChoice::rbf, sampled(4, 3, plane))->kind(), SurrogateKind::constant);
}

TEST(Polynomial, StatesTheStandardErrorOfAMean)
{
    // A constant fitted to n values: the mean, with its standard error sqrt(sum (y - mean)^2/(n - 1)/n).
    Samples const samples{MatrixXd::Zero(4, 1), VectorXd{{1, 2, 3, 6}}, VectorXd::Ones(4)};
    Polynomial const fit(SurrogateKind::constant, samples);
    EXPECT_DOUBLE_EQ(fit.value(VectorXd::Zero(1)), 3);
    EXPECT_NEAR(fit.standard_deviation(VectorXd::Zero(1)), std::sqrt((4 + 1 + 0 + 9) / 3.0 / 4), 1e-12);
    EXPECT_EQ(fit.degrees_of_freedom(), 3);
}

TEST(Polynomial, StatesTheSameForMeansOfManyRuns)
{
    // Means that scatter by as much are as good whatever number of runs is behind each: the scatter between
    // the means tells the error, and the number of runs must not make it smaller once more.
    auto once = sampled(12, 2, [](VectorXd const& x) { return 1 + x[0]; });
    RandomStream random(4);
    for (double& value : once.values)
        value += 0.1 * normal(random);
    auto sixteen = once;
    sixteen.weights.setConstant(16);
    VectorXd const point{{0.3, 0.8}};
    EXPECT_NEAR(Polynomial(SurrogateKind::linear, sixteen).standard_deviation(point),
                Polynomial(SurrogateKind::linear, once).standard_deviation(point), 1e-12);
    EXPECT_NEAR(RadialBasis(sixteen, 16 * 0.3).standard_deviation(point),
                RadialBasis(once, 0.3).standard_deviation(point), 1e-12);
}

TEST(Polynomial, AMeanOfManyRunsCountsAsThatMany)
{
    // A constant through means over 1 and 3 runs, 1 and 5: the mean 4 of all four runs. Their deviations tell
    // of runs of variance (1 x 9 + 3 x 1)/1 = 12, the mean of four has a quarter of it.
    Samples const samples{MatrixXd::Zero(2, 1), VectorXd{{1, 5}}, VectorXd{{1, 3}}};
    Polynomial const fit(SurrogateKind::constant, samples);
    EXPECT_NEAR(fit.value(VectorXd::Zero(1)), 4, 1e-14);
    EXPECT_NEAR(fit.standard_deviation(VectorXd::Zero(1)), std::sqrt(12.0 / 4), 1e-12);
}

TEST(RadialBasis, IsTheNaturalCubicSplineInOneDimension)
{
    // Knots 0, 1/2, 1 with values 0, 1, 0: the spline through them is 3x - 4x^3 on the left half.
    Samples const samples{MatrixXd{{0.0}, {0.5}, {1.0}}, VectorXd{{0, 1, 0}}, VectorXd::Ones(3)};
    RadialBasis const spline(samples, 0);
    for (double x : {0.0, 0.1, 0.25, 0.4, 0.5})
        EXPECT_NEAR(spline.value(VectorXd{{x}}), 3 * x - 4 * x * x * x, 1e-12);
}

TEST(RadialBasis, ReproducesLinearFunctionsAtAnySmoothing)
{
    auto const plane = [](VectorXd const& x) { return 2 - 3 * x[0] + 0.5 * x[1] + x[2]; };
    auto const samples = sampled(12, 3, plane);
    for (double smoothing : {0.0, 0.1, 100.0}) {
        RadialBasis const fit(samples, smoothing);
        EXPECT_NEAR(fit.value(VectorXd{{0.9, 0.05, 0.3}}), 2 - 2.7 + 0.025 + 0.3, 1e-11);
        EXPECT_LT(fit.leave_one_out_errors().cwiseAbs().maxCoeff(), 1e-10);
    }
}

TEST(RadialBasis, InterpolatesWithoutSmoothing)
{
    auto const samples = sampled(25, 3, wavy);
    RadialBasis const fit(samples, 0);
    for (int i = 0; i < 25; ++i)
        EXPECT_NEAR(fit.value(samples.points.row(i).transpose()), samples.values[i], 1e-11);
}

TEST(RadialBasis, HasTheGradientOfItsValue)
{
    expect_gradient_matches_differences(RadialBasis(sampled(25, 3, wavy), 0.01), 3);
}

TEST(RadialBasis, LeaveOneOutErrorsAreThoseOfFitsWithoutThePoint)
{
    auto samples = sampled(12, 3, wavy);
    samples.weights[3] = 4;
    for (double smoothing : {0.0, 0.05}) {
        RadialBasis const fit(samples, smoothing);
        for (int i = 0; i < 12; ++i) {
            RadialBasis const rest(without(samples, i), smoothing);
            EXPECT_NEAR(fit.leave_one_out_errors()[i],
                        samples.values[i] - rest.value(samples.points.row(i).transpose()), 1e-8);
        }
    }
}

TEST(RadialBasis, ALocationThatWasRunTwiceCountsAsTwoAtTheSamePlace)
{
    // Two runs of 1.0 and 3.0 at one place pull a smoothed fit like two separate samples in almost the same
    // place.
    auto merged = sampled(8, 2, [](VectorXd const& x) { return x[0] * x[0]; });
    auto split = merged;
    merged.values[0] = 2, merged.weights[0] = 2;
    split.points.conservativeResize(9, 2), split.values.conservativeResize(9),
        split.weights.conservativeResize(9);
    split.points.row(8) = split.points.row(0), split.weights[8] = 1;
    split.points(8, 0) += 1e-7;
    split.values[0] = 1, split.values[8] = 3;
    VectorXd const x{{0.3, 0.6}};
    EXPECT_NEAR(RadialBasis(merged, 0.1).value(x), RadialBasis(split, 0.1).value(x), 1e-6);
}

TEST(RadialBasis, SmoothsNoiseAwayAndStatesHowWellItDoes)
{
    // A quarter wave with noise of 0.1: the prediction must be nearer to the truth than the data, and the
    // stated deviation must be of the size of the error made.
    auto const truth = [](VectorXd const& x) { return std::sin(1.5 * x[0]) + x[1]; };
    auto samples = sampled(60, 2, truth);
    RandomStream random(3);
    for (double& value : samples.values) {
        double normal = -6;
        for (int i = 0; i < 12; ++i)
            normal += random.uniform();
        value += 0.1 * normal;
    }
    RadialBasis const fit(samples);
    EXPECT_GT(fit.smoothing(), 0);
    EXPECT_NEAR(leave_one_out_rmse(fit, samples), 0.1, 0.025);
    double error = 0, stated = 0;
    for (double x : {0.2, 0.4, 0.6, 0.8})
        for (double y : {0.2, 0.4, 0.6, 0.8}) {
            VectorXd const point{{x, y}};
            error += std::pow(fit.value(point) - truth(point), 2) / 16;
            stated += std::pow(fit.standard_deviation(point), 2) / 16;
        }
    EXPECT_LT(std::sqrt(error), 0.05);
    EXPECT_LT(std::sqrt(error), 2 * std::sqrt(stated));
    EXPECT_LT(std::sqrt(stated), 0.05);
}

} // namespace
} // namespace demens::tao_calib
