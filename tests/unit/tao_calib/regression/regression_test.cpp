// What a fitted polynomial says, and what cannot be fitted.
#include "tao_calib/regression/analysis.hpp"
#include "tao_calib/regression/own_units.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/design/fractional_factorial.hpp"
#include "tests/unit/tao_calib/regression/regression_cases.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;
using namespace demens::tao_calib::testing;

namespace {

std::string message(auto&& action)
{
    try {
        action();
    } catch (InputError const& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

// Leave-one-out by refitting: PRESS needs no refits, but has to agree with them.
TEST(Regression, PredictedRSquaredIsThatOfRefits)
{
    auto const data = central_composite_data();
    auto const terms = polynomial_terms(PolynomialModel::quadratic, 2);
    Regression const fit(data, terms);
    double press = 0;
    for (int left = 0; left < 13; ++left) {
        auto others = data;
        others.coded.resize(12, 2);
        others.values.resize(12);
        for (int i = 0, row = 0; i < 13; ++i)
            if (i != left) {
                others.coded.row(row) = data.coded.row(i);
                others.values[row++] = data.values[i];
            }
        press += std::pow(
            data.values[left] - Regression(others, terms).predict(data.coded.row(left).transpose()), 2);
    }
    EXPECT_NEAR(fit.prediction_sum_of_squares(), press, 1e-10);
    EXPECT_NEAR(fit.leverages().sum(), 6, 1e-12);
}

TEST(Regression, SharesOfAKnownPlane)
{
    auto const data =
        data_of(FractionalFactorial(2, std::vector<std::string>{}).coded(), {-4, 2, -2, 4}); // 3 A + B
    EXPECT_NEAR(influence_shares(data)[0], 0.75, 1e-12);
    EXPECT_NEAR(influence_shares(data)[1], 0.25, 1e-12);
}

// y = 5 + A^2 + 2 B exactly: without B's part the runs follow A^2 plus the mean of the rest.
TEST(Regression, AdjustedResponseTakesTheOthersOut)
{
    Eigen::MatrixXd x(8, 2);
    x << -1, -1, 0, -1, 1, -1, -1, 1, 0, 1, 1, 1, 0.5, 0, -0.5, 0.25;
    std::vector<double> y;
    for (int i = 0; i < 8; ++i)
        y.push_back(5 + x(i, 0) * x(i, 0) + 2 * x(i, 1));
    Regression const fit(data_of(x, y), polynomial_terms(PolynomialModel::quadratic, 2));
    auto const adjusted = adjusted_response(fit, 0);
    double const mean_of_b = x.col(1).mean();
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(adjusted[i], 5 + x(i, 0) * x(i, 0) + 2 * mean_of_b, 1e-10);
}

TEST(Regression, SlopeAndErrorOfThePrediction)
{
    Regression const fit(central_composite_data(), polynomial_terms(PolynomialModel::quadratic, 2));
    Eigen::Vector2d const point(.4, -.6);
    double const step = 1e-5;
    for (int k = 0; k < 2; ++k) {
        Eigen::Vector2d const shift = step * Eigen::Vector2d::Unit(k);
        EXPECT_NEAR(fit.gradient(point)[k],
                    (fit.predict(point + shift) - fit.predict(point - shift)) / (2 * step), 1e-8);
    }
    // At a run the variance of the fitted mean is leverage times residual variance.
    EXPECT_NEAR(fit.prediction_standard_error(fit.data().coded.row(9).transpose()),
                fit.residual_standard_deviation() * std::sqrt(fit.leverages()[9]), 1e-12);
}

TEST(Regression, NamesTermsThatCannotBeToldApart)
{
    auto const half = data_of(FractionalFactorial(3, {"C=AB"}).coded(), {1, 2, 3, 5});
    EXPECT_EQ(aliased_terms(half, terms_of(3, {"A", "B", "C"})), std::vector<std::string>{});
    EXPECT_EQ(message([&] {
                  Regression(half, terms_of(3, {"A", "C", "AB"}));
              }),
              "response `y`: the runs cannot tell these terms apart: A*B = C; leave terms out or add runs");
    EXPECT_EQ(aliased_terms(half, terms_of(3, {"A", "AA"})), std::vector<std::string>{"A^2 = constant"});
    // Kinetic friction always .8 of the static one: B = 0.8 A, less what the coding shifts.
    Eigen::MatrixXd tied(5, 2);
    tied << -1, -.8, -.5, -.4, 0, 0, .5, .4, 1, .8;
    EXPECT_EQ(aliased_terms(data_of(tied, {1, 2, 3, 4, 6}), terms_of(2, {"A", "B"})),
              std::vector<std::string>{"B = 0.8 A"});
}

TEST(Regression, RefusesWhatItCannotFit)
{
    auto const factorial = FractionalFactorial(2, std::vector<std::string>{}).coded();
    auto const quadratic = polynomial_terms(PolynomialModel::quadratic, 2);
    EXPECT_EQ(message([&] {
                  Regression(data_of(factorial, {1, 2, 3, 5}), quadratic);
              }),
              "response `y`: 4 runs cannot determine 6 coefficients: add runs or take a smaller model");
    EXPECT_EQ(message([&] {
                  Regression(data_of(factorial, {7, 7, 7, 7}), terms_of(2, {"A"}));
              }),
              "response `y` is 7 in all 4 runs: there is nothing to fit");
    EXPECT_EQ(message([&] {
                  Regression(data_of(factorial, {1, NAN, 3, 4}), terms_of(2, {"A"}));
              }),
              "response `y`: run 2 has a number missing: leave the run out");
    EXPECT_EQ(message([&] {
                  eliminate_backward(data_of(factorial, {1, 2, 3, 5}), terms_of(2, {"A", "B", "AB"}));
              }),
              "response `y`: 4 runs leave nothing to test 4 coefficients against: add runs or take a smaller "
              "model");
}

// The same polynomial in other units: x = 100 + 50 u and ln z between 1 and e^2.
TEST(Regression, OwnUnitsAreTheSamePolynomial)
{
    auto const data = central_composite_data();
    Regression const fit(data, polynomial_terms(PolynomialModel::quadratic, 2));
    auto const own = in_own_units(fit, {{"x", -2, 1.0 / 50}, {"ln(z)", -1, 1}});
    ASSERT_EQ(own.size(), 6u);
    char const* const names[] = {"constant", "x", "ln(z)", "x*ln(z)", "x^2", "ln(z)^2"};
    double const x = 123, log_z = 1.7;
    double const powers[] = {1, x, log_z, x * log_z, x * x, log_z * log_z};
    double sum = 0;
    for (int k = 0; k < 6; ++k) {
        EXPECT_EQ(own[k].term, names[k]);
        sum += own[k].value * powers[k];
    }
    EXPECT_NEAR(sum, fit.predict(Eigen::Vector2d(x / 50 - 2, log_z - 1)), 1e-10);
    EXPECT_NEAR(own[4].standard_error, fit.coefficients()[4].standard_error / 2500,
                1e-15); // x^2 alone makes x^2
}
