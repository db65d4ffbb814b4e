#include "tests/unit/gap/statistics/small_evidence.hpp"

#include "gap/statistics/form_floor.hpp"
#include "gap/statistics/twins.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

// By hand: rows (1,1), (-1,-1), (1,-1), (-1,1), (2,2), (-2,-2) have S = [2, 4/3; 4/3, 2], correlation 2/3.
// Each row's square over 2 is y y' with entries 1/2, +-1/2 or 2, 2. Sum over rows of |y y' - R|^2, R = [1,
// 2/3; 2/3, 1]: (1,1): 2/4 + 2/36 = 5/9, twice; (1,-1): 2/4 + 2 (7/6)^2 = 29/9, twice; (2,2): 2 + 2 (4/3)^2 =
// 50/9, twice.
TEST(LedoitWolf, IsTheFormulaByHand)
{
    Eigen::MatrixXd rows(6, 2);
    rows << 1, 1, -1, -1, 1, -1, -1, 1, 2, 2, -2, -2;
    double const scatter = 2 * (5 + 29 + 50) / 9. / 36, off_target = 2 * 4 / 9.;
    auto const shrunk = shrunk_covariance(rows, 6);
    EXPECT_NEAR(shrunk.share, scatter / off_target, 1e-14);
    EXPECT_NEAR(shrunk.covariance(0, 0), 2, 1e-14);
    EXPECT_NEAR(shrunk.covariance(0, 1), (1 - scatter / off_target) * 4 / 3, 1e-14);

    // Units do not matter, and a cell that never changes has no part in it.
    Eigen::MatrixXd other(6, 3);
    other << 1000 * rows.col(0), Eigen::VectorXd::Zero(6), 0.01 * rows.col(1);
    auto const same = shrunk_covariance(other, 6);
    EXPECT_NEAR(same.share, shrunk.share, 1e-13);
    EXPECT_NEAR(same.covariance(0, 2), 10 * shrunk.covariance(0, 1), 1e-12);
    EXPECT_EQ(same.covariance(1, 1), 0);
}

TEST(LedoitWolf, FewRunsOfIndependentResponsesGiveNoCorrelation)
{
    demens::RandomStream random(3);
    Eigen::MatrixXd rows(4, 12);
    for (auto& number : rows.reshaped())
        number = standard_normal(random);
    EXPECT_GT(shrunk_covariance(rows, 4).share, 0.7);
    EXPECT_NO_THROW(shrunk_covariance(rows.topRows(1), 1));
}

TEST(Floor, IsTheSumOfItsParts)
{
    auto evidence = small_evidence(2, 2, 1);
    evidence.repeats = Eigen::VectorXd::Constant(4, 4);
    evidence.surrogate_variance = Eigen::VectorXd::LinSpaced(4, 0.1, 0.4);
    Eigen::MatrixXd rows(3, 2);
    rows << 0.5, 0, -0.5, 0, 0, 0;
    evidence.packing = {{{0, 1}, rows, 2, 5}};
    auto const floor = make_floor(evidence);
    // cell 0.0 has scale 10, sd 2 % of it, 4 repeats; seeds 0.25 of 5 packings
    EXPECT_NEAR(floor.experiment(0, 0), 0.04 / 4, 1e-15);
    EXPECT_NEAR(floor.seed(0, 0), 0.25 / 5, 1e-15);
    EXPECT_EQ(floor.seed(1, 1), 0);
    EXPECT_NEAR(floor.surrogate(3, 3), 0.4, 1e-15);
    EXPECT_NEAR(floor.form(0, 0), 0.16, 1e-15);
    // the same response at the other condition, two lengths away: (1 + x) exp(-x), x = 2 sqrt 3
    double const x = 2 * std::sqrt(3);
    EXPECT_NEAR(floor.form(0, 2), 0.16 * (1 + x) * std::exp(-x), 1e-15);
    EXPECT_EQ(floor.form(0, 1), 0);
    EXPECT_NEAR(floor.deviations()[0], std::sqrt(0.01 + 0.05 + 0.1 + 0.16), 1e-14);
}

// 50 cases of 12 cells in which nothing is missing but that the laws are off by 6 %.
TEST(Floor, IsEstimatedFromCasesWithoutEffect)
{
    std::vector<Evidence> cases;
    for (int i = 0; i < 50; ++i) {
        auto const truth = small_evidence(3, 4, 2, 0.06);
        cases.push_back(small_evidence(3, 4, 2, 0.04));
        cases.back().measured += Twins(truth, make_floor(truth).total(), 31).base(i);
    }
    auto const found = estimate_form_floor(cases);
    EXPECT_NEAR(found.most_likely, 0.06, 0.006);
    EXPECT_GT(found.upper, found.most_likely);
    EXPECT_LT(found.upper, 0.075);
    EXPECT_EQ(
        message([] { estimate_form_floor({}); }),
        "the form floor is estimated from no case: give cases in which nothing is missing, or say a floor");
}

TEST(Evidence, PartsAreThoseOfTheWhole)
{
    auto evidence = small_evidence(2, 3, 2);
    evidence.surrogate_variance = Eigen::VectorXd::LinSpaced(6, 1, 6);
    Eigen::MatrixXd const rows = Eigen::MatrixXd::Random(5, 3);
    evidence.packing = {{{0, 1, 2}, rows, 4, 2}, {{3, 4, 5}, 2 * rows, 4, 2}};
    std::vector<int> const cells{4, 1, 3};
    auto const part = subset(evidence, cells);
    check(part);
    auto const whole = make_floor(evidence), floor = make_floor(part);
    EXPECT_TRUE(floor.form.isApprox(whole.form(cells, cells), 1e-12));
    EXPECT_EQ(floor.surrogate.diagonal(), Eigen::Vector3d(5, 2, 4));
    EXPECT_TRUE(floor.seed.diagonal().isApprox(whole.seed.diagonal()(cells), 1e-12));
    EXPECT_EQ(floor.seed(0, 1), 0);
    EXPECT_EQ(part.packing[1].cells, (std::vector<int>{2, 0}));
    EXPECT_EQ(subset(random_signature(evidence, 1, 3), cells).first[0],
              random_signature(evidence, 1, 3).first[4]);
}

TEST(Evidence, SaysWhatIsWrongWithIt)
{
    auto bad = small_evidence(2, 2, 1);
    bad.predicted[2] = NAN;
    EXPECT_EQ(
        message([&] { check(bad); }),
        "cell `cell 1.0`: `predicted` is not a number: leave the cell out, or find out why its runs failed");
    bad = small_evidence(2, 2, 1);
    bad.experiment_variance[1] = NAN;
    EXPECT_EQ(message([&] { check(bad); }),
              "cell `cell 0.1`: `experiment_variance` is not a number: give the sd of the measurement");
    bad = small_evidence(2, 2, 1);
    bad.measured.conservativeResize(3);
    EXPECT_EQ(message([&] { check(bad); }),
              "the evidence has 3 numbers in `measured` for 4 cells: give one for each");
    bad = small_evidence(2, 2, 1);
    bad.nuisance_prior(0, 0) = -1;
    EXPECT_EQ(message([&] { check(bad); }), "`nuisance_prior` is no covariance: it is symmetric, no variance "
                                            "is negative and no number is missing");
    bad = small_evidence(2, 2, 1);
    bad.experiment_correlation = Eigen::MatrixXd::Constant(4, 4, 2);
    EXPECT_EQ(message([&] { check(bad); }),
              "`experiment_correlation` is no correlation: it is symmetric, has ones on "
              "its diagonal and numbers from -1 to 1");
    EXPECT_EQ(message([&] { check(Evidence{}); }),
              "the evidence has no cell: nothing was measured that could be compared");
    auto const evidence = small_evidence(2, 2, 1);
    auto effect = random_signature(evidence, 1, 5);
    effect.first[3] = NAN;
    EXPECT_EQ(message([&] { check(effect, evidence); }),
              "effect `effect 5`: `first` has a number that is missing: leave the cell out, or the effect");
}
