// Which terms a model keeps.
#include "tao_calib/regression/analysis.hpp"

#include "demens/base/random.hpp"
#include "tao_calib/design/fractional_factorial.hpp"
#include "tests/unit/tao_calib/regression/regression_cases.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;
using namespace demens::tao_calib::testing;

TEST(Regression, StrictHierarchyKeepsAFactorWhoseSquareMatters)
{
    Eigen::MatrixXd x(7, 1);
    x << -1, -.7, -.3, 0, .3, .7, 1;
    std::vector<double> y;
    double const noise[] = {.01, -.02, .015, -.005, .01, -.01, .002};
    for (int i = 0; i < 7; ++i)
        y.push_back(2 + 3 * x(i, 0) * x(i, 0) + noise[i]);
    auto const data = data_of(x, y);
    auto const quadratic = polynomial_terms(PolynomialModel::quadratic, 1);
    auto const strict = eliminate_backward(data, quadratic, {.hierarchy = Hierarchy::strict}).regression;
    ASSERT_EQ(strict.terms(), quadratic);
    EXPECT_GT(strict.coefficients()[1].p, 0.05);
    EXPECT_EQ(eliminate_backward(data, quadratic).regression.terms(), terms_of(1, {"AA"}));
}

// y = 1 + A B + noise: neither main effect matters alone, but the product keeps both.
TEST(Regression, ProductKeepsItsFactors)
{
    auto const data = data_of(FractionalFactorial(3, std::vector<std::string>{}).coded(),
                              {2.1, 0, .1, 1.9, 1.9, .1, -.1, 2.1});
    auto const reduced = eliminate_backward(data, terms_of(3, {"A", "B", "C", "AB"}));
    EXPECT_EQ(reduced.regression.terms(), terms_of(3, {"A", "B", "AB"}));
    EXPECT_GT(reduced.regression.coefficients()[1].p, 0.05);
}

// Terms leave one by one, from the covariance or by decompositions anew: the same ones either way.
TEST(Regression, EliminationOfManyTermsIsThatOfRefits)
{
    constexpr int factors = 11, runs = 150; // 78 terms
    RandomStream random(5);
    Eigen::MatrixXd x(runs, factors);
    std::vector<double> y;
    for (int i = 0; i < runs; ++i) {
        for (int k = 0; k < factors; ++k)
            x(i, k) = 2 * random.uniform() - 1;
        y.push_back(x(i, 0) - x(i, 1) * x(i, 2) + x(i, 3) * x(i, 3) + 0.3 * (random.uniform() - 0.5));
    }
    auto const data = data_of(x, y);
    auto const terms = polynomial_terms(PolynomialModel::quadratic, factors);
    auto const reduced = eliminate_backward(data, terms);
    auto kept = terms;
    for (auto const& [term, p] : reduced.eliminated) {
        Regression const before(data, kept);
        auto const place = std::find(kept.begin(), kept.end(), term);
        ASSERT_NE(place, kept.end());
        EXPECT_NEAR(before.coefficients()[static_cast<std::size_t>(place - kept.begin())].p, p, 1e-9);
        kept.erase(place);
    }
    EXPECT_EQ(reduced.regression.terms(), kept);
    EXPECT_GT(reduced.eliminated.size(), 60u);
}
