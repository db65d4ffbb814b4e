// Data with published analyses.
#include "tao_calib/regression/analysis.hpp"
#include "tao_calib/regression/table_column.hpp"

#include "tao_calib/design/fractional_factorial.hpp"
#include "tests/unit/tao_calib/regression/regression_cases.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;
using namespace demens::tao_calib::testing;

namespace {

AnovaRow row_of(std::vector<AnovaRow> const& rows, std::string const& source)
{
    for (auto const& row : rows)
        if (row.source == source)
            return row;
    throw std::runtime_error("no row " + source);
}

//! NIST StRD, Longley (1967): collinear columns of raw numbers.
RegressionData longley()
{
    Eigen::MatrixXd table(16, 7);
    table << 60323, 83.0, 234289, 2356, 1590, 107608, 1947, 61122, 88.5, 259426, 2325, 1456, 108632, 1948,
        60171, 88.2, 258054, 3682, 1616, 109773, 1949, 61187, 89.5, 284599, 3351, 1650, 110929, 1950, 63221,
        96.2, 328975, 2099, 3099, 112075, 1951, 63639, 98.1, 346999, 1932, 3594, 113270, 1952, 64989, 99.0,
        365385, 1870, 3547, 115094, 1953, 63761, 100.0, 363112, 3578, 3350, 116219, 1954, 66019, 101.2,
        397469, 2904, 3048, 117388, 1955, 67857, 104.6, 419180, 2822, 2857, 118734, 1956, 68169, 108.4,
        442769, 2936, 2798, 120445, 1957, 66513, 110.8, 444546, 4681, 2637, 121950, 1958, 68655, 112.6,
        482704, 3813, 2552, 123366, 1959, 69564, 114.2, 502601, 3931, 2514, 125368, 1960, 69331, 115.7,
        518173, 4806, 2572, 127852, 1961, 70551, 116.9, 554894, 4007, 2827, 130081, 1962;
    return {{"x1", "x2", "x3", "x4", "x5", "x6"}, "employed", table.rightCols(6), table.col(0)};
}

} // namespace

// Montgomery, Design and Analysis of Experiments, example 8.4, by the model A, B, AB.
TEST(Regression, InjectionMoulding)
{
    auto const data = data_of(FractionalFactorial(6, {"E=ABC", "F=BCD"}).coded(),
                              {6, 10, 32, 60, 4, 15, 26, 60, 8, 12, 34, 60, 16, 5, 37, 52});
    Regression const fit(data, terms_of(6, {"A", "B", "AB"}));
    EXPECT_NEAR(fit.r_squared(), .962647, 5e-7);
    EXPECT_NEAR(fit.adjusted_r_squared(), .953309, 5e-7);

    auto const effects = pareto(fit);
    ASSERT_EQ(effects.size(), 3u);
    EXPECT_EQ(effects[0].term, "B");
    EXPECT_NEAR(effects[0].effect, 35.625, 1e-12);
    EXPECT_NEAR(effects[1].effect, 13.875, 1e-12);
    EXPECT_EQ(effects[2].term, "A*B");
    EXPECT_NEAR(effects[2].effect, 11.875, 1e-12);
    // An orthogonal design shares the model's sum of squares out among its effects: N effect^2 / 4.
    auto const anova = analysis_of_variance(fit);
    EXPECT_NEAR(row_of(anova, "B").sum_of_squares, 16 * 35.625 * 35.625 / 4, 1e-9);
    EXPECT_NEAR(row_of(anova, "A").sum_of_squares + row_of(anova, "B").sum_of_squares +
                    row_of(anova, "A*B").sum_of_squares,
                row_of(anova, "model").sum_of_squares, 1e-9);
    EXPECT_NEAR(row_of(anova, "B").f, std::pow(effects[0].standardised, 2), 1e-9);
}

// Montgomery, example 6.2: filtration rate, 2^4.
TEST(Regression, FiltrationRate)
{
    auto const data = data_of(FractionalFactorial(4, std::vector<std::string>{}).coded(),
                              {45, 71, 48, 65, 68, 60, 80, 65, 43, 100, 45, 104, 75, 86, 70, 96});
    Regression const fit(data, terms_of(4, {"A", "C", "D", "AC", "AD"}));
    double const effects[] = {21.625, 9.875, 14.625, -18.125, 16.625};
    for (int t = 0; t < 5; ++t)
        EXPECT_NEAR(2 * fit.coefficients()[t + 1].value, effects[t], 1e-12);
    EXPECT_NEAR(fit.r_squared(), .965952, 5e-7);
    EXPECT_NEAR(fit.adjusted_r_squared(), .948929, 5e-7);

    // All main effects and two-factor products: elimination at 5 % finds the same model.
    auto const reduced = eliminate_backward(data, polynomial_terms(PolynomialModel::interaction, 4));
    EXPECT_EQ(reduced.regression.terms(), terms_of(4, {"A", "C", "D", "AC", "AD"}));
    EXPECT_EQ(reduced.eliminated.size(), 5u);
}

// Montgomery, example 11.2: yield by time and temperature.
TEST(Regression, CentralCompositeTable)
{
    Regression const fit(central_composite_data(), polynomial_terms(PolynomialModel::quadratic, 2));
    double const expected[] = {79.93995, .99505, .5152, .25, -1.37645, -1.00134};
    for (int t = 0; t < 6; ++t)
        EXPECT_NEAR(fit.coefficients()[t].value, expected[t], 6e-6) << t;
    EXPECT_NEAR(fit.adjusted_r_squared(), .9704, 5e-5);
    auto const anova = analysis_of_variance(fit);
    EXPECT_NEAR(row_of(anova, "lack of fit").f, 1.789, 5e-4);
    EXPECT_EQ(row_of(anova, "lack of fit").degrees_of_freedom, 3);
    EXPECT_EQ(row_of(anova, "pure error").degrees_of_freedom, 4);
    EXPECT_NEAR(row_of(anova, "pure error").sum_of_squares, 0.212, 1e-12);

    auto const stationary = stationary_point(fit);
    ASSERT_TRUE(stationary);
    EXPECT_NEAR(stationary->coded[0], .3892, 1e-4);
    EXPECT_NEAR(stationary->coded[1], .3058, 1e-4);
    EXPECT_NEAR(stationary->value, 80.212, 5e-4);
    EXPECT_LT(stationary->curvatures.maxCoeff(), 0);
}

TEST(Regression, Longley)
{
    Regression const fit(longley(), polynomial_terms(PolynomialModel::linear, 6));
    double const certified[] = {-3482258.63459582, 15.0618722713733,  -0.358191792925910E-01,
                                -2.02022980381683, -1.03322686717359, -0.511041056535807E-01,
                                1829.15146461355};
    for (int t = 0; t < 7; ++t)
        EXPECT_NEAR(fit.coefficients()[t].value / certified[t], 1, 1e-9) << t;
    EXPECT_NEAR(fit.residual_sum_of_squares() / 836424.055505915, 1, 1e-9);
    EXPECT_NEAR(fit.coefficients()[0].standard_error / 890420.383607373, 1, 1e-9);
    EXPECT_NEAR(fit.r_squared(), 0.995479004577296, 1e-12);
    // F 330.285339234588 of 6 and 9 degrees of freedom
    EXPECT_NEAR(analysis_of_variance(fit)[0].f, 330.285339234588, 1e-6);
}

// Variance inflation factors of Longley's data (NIST StRD gives the data, Chatterjee and Hadi the factors):
// 135.53, 1788.51, 33.62, 3.59, 399.15, 758.98.
TEST(Regression, VarianceInflationOfLongley)
{
    Regression const fit(longley(), polynomial_terms(PolynomialModel::linear, 6));
    auto const factors = variance_inflation(fit);
    double const expected[] = {135.53, 1788.51, 33.62, 3.59, 399.15, 758.98};
    EXPECT_TRUE(std::isnan(factors[0]));
    for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(factors[k + 1], expected[k], 0.006) << k;
}

// NIST StRD Wampler1: y = 1 + x + ... + x^5 without scatter, x = 0..20. All coefficients 1, R2 1, no error.
TEST(Regression, WamplerOneHasNoScatter)
{
    RegressionData data{{"x"}, "y", Eigen::MatrixXd(21, 1), Eigen::VectorXd(21)};
    std::vector<Term> terms;
    for (int power = 0; power <= 5; ++power)
        terms.push_back({{power}});
    for (int i = 0; i <= 20; ++i) {
        data.coded(i, 0) = i;
        data.values[i] = 0;
        for (int power = 0; power <= 5; ++power)
            data.values[i] += std::pow(i, power);
    }
    Regression const fit(data, terms);
    for (auto const& coefficient : fit.coefficients())
        EXPECT_NEAR(coefficient.value, 1, 1e-7);
    EXPECT_EQ(fit.scatter(), Scatter::none);
    EXPECT_TRUE(std::isnan(analysis_of_variance(fit)[0].f));
}

// El Kassem et al. (2021), Table 6, where it prints .975, .983, .998, .986; hierarchy by products.
TEST(Regression, AugerDosingOfLactose)
{
    auto const table = demens::text::CsvTable::from_file(DEMENS_TEST_DATA "/auger_lactose_doe.csv");
    RegressionData data{{"speed", "mu_s_pp", "mu_s_pw", "mu_r_pp"}, "", Eigen::MatrixXd(20, 4), {}};
    Eigen::Vector4d const lower(400, .3, .1, .1), upper(800, .8, .4, .7);
    for (int k = 0; k < 4; ++k)
        data.coded.col(k) =
            2 * (column_values(table, data.factors[k]).array() - lower[k]) / (upper[k] - lower[k]) - 1;
    std::pair<char const*, double> const published[] = {
        {"aor", .974}, {"bulk_density", .983}, {"mass_flow", .998}, {"na_tke", .986}};
    for (auto const& [response, adjusted_r_squared] : published) {
        data.response = response;
        data.values = column_values(table, response);
        auto const reduced = eliminate_backward(data, polynomial_terms(PolynomialModel::quadratic, 4));
        EXPECT_NEAR(reduced.regression.adjusted_r_squared(), adjusted_r_squared, 5e-4) << response;
        EXPECT_GT(reduced.regression.predicted_r_squared(), 0.9) << response;
    }

    // Figure 8: rolling friction rules the angle of repose, the wall hardly matters; figure 10: speed up,
    // wall down.
    data.response = "aor";
    data.values = column_values(table, "aor");
    auto const shares = influence_shares(data);
    EXPECT_NEAR(shares.sum(), 1, 1e-12);
    EXPECT_GT(shares[3], shares[1]);
    EXPECT_GT(shares[1], shares[0]);
    EXPECT_GT(shares[0], shares[2]);
    data.values = column_values(table, "mass_flow");
    auto const effects =
        pareto(eliminate_backward(data, polynomial_terms(PolynomialModel::quadratic, 4)).regression);
    EXPECT_EQ(effects[0].term, "speed");
    EXPECT_GT(effects[0].effect, 0);
    EXPECT_EQ(effects[1].term, "mu_s_pw");
    EXPECT_LT(effects[1].effect, 0);
}
