#include "gap/statistics/decoys.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/closure_coverage.hpp"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace demens::gap;
using namespace demens::gap::testing;

namespace {

HeldOutPrediction prediction(Eigen::VectorXd const& mean)
{
    return {mean.transpose(), {}};
}

} // namespace

// Two cells with sd 2: off by 6 and 8 before, 2 and 0 after. D^2 = (9 + 16) / 2 and 1/2, E = 11.5 and -.5.
TEST(Quantify, ClosureByHand)
{
    auto evidence = small_evidence(1, 2, 0, 0.0);
    evidence.experiment_variance.setConstant(4);
    evidence.measured = Eigen::Vector2d(10, 20);
    auto const found =
        quantify(held_out(evidence), prediction(Eigen::Vector2d(4, 12)), prediction(Eigen::Vector2d(8, 20)));
    EXPECT_NEAR(found.before.square, 12.5, 1e-12);
    EXPECT_NEAR(found.before.excess, 11.5, 1e-12);
    EXPECT_NEAR(found.after.excess, -0.5, 1e-12);
    EXPECT_EQ(found.closure, 1); // not more
    EXPECT_NEAR(found.before.floor_limit, 5.991 / 2, 1e-3);
    EXPECT_EQ(found.cells[1].before, 8);
    EXPECT_EQ(found.cells[0].after, 2);
    EXPECT_NEAR(found.cells[0].floor, 2, 1e-12);

    auto const half =
        quantify(held_out(evidence), prediction(Eigen::Vector2d(4, 12)), prediction(Eigen::Vector2d(4, 20)));
    EXPECT_NEAR(half.closure, 1 - 3.5 / 11.5, 1e-12);
    EXPECT_LT(half.lower, half.closure);
    EXPECT_GT(half.upper, half.closure);

    auto const floor =
        quantify(held_out(evidence), prediction(Eigen::Vector2d(9, 18)), prediction(Eigen::Vector2d(10, 20)));
    EXPECT_TRUE(floor.at_floor);
    EXPECT_TRUE(std::isnan(floor.closure));
}

// Twins of fitted and held-out cells together, so that their form errors belong together: after a fit to the
// former the mean excess of the latter is 0.
TEST(Quantify, ExcessIsZeroInTheMeanWhereNothingIsMissing)
{
    auto const all = small_evidence(5, 2, 2);
    std::vector<int> const in{0, 1, 2, 3, 8, 9}, out{4, 5, 6, 7};
    auto fitted = subset(all, in), others = subset(all, out);
    Projection const projection(fitted, make_floor(fitted).total());
    Eigen::MatrixXd const estimation = estimation_covariance(fitted, projection, others);
    Twins const twins(all, make_floor(all).total(), 17);
    double sum = 0, beyond = 0;
    int const count = 3000;
    for (int i = 0; i < count; ++i) {
        Eigen::VectorXd const r = twins.base(i);
        auto const fit = refit(fitted, projection, r(in));
        others.measured = others.predicted + r(out);
        HeldOutPrediction const predicted{(others.predicted + others.nuisance * fit.factors).transpose(),
                                          estimation};
        auto const found = excess_misfit(held_out(others), predicted);
        sum += found.excess / count;
        beyond += !found.at_floor() / static_cast<double>(count);
    }
    EXPECT_NEAR(sum, 0, 0.05); // standard error about .015
    EXPECT_NEAR(beyond, 0.05, 0.02);
}

// 90 % of 150 cases: 135 +- 3.7; also where two experiments are all there is.
TEST(Quantify, IntervalHoldsTheClosureOfAllConditions)
{
    for (int experiments : {2, 6}) {
        auto const found = closure_coverage(experiments, 150);
        EXPECT_GT(found.judged, 130) << experiments;
        EXPECT_NEAR(1. * found.held / found.judged, 0.90, 0.06) << experiments;
    }
}

TEST(Quantify, SaysWhatIsWrong)
{
    EXPECT_EQ(message([] { held_out(Evidence{}); }), "no experiment is held out: how far an effect closes "
                                                     "the gap can only be said on experiments that took "
                                                     "no part in the fit; name some in `held_out`");
    auto const evidence = small_evidence(1, 2, 1);
    EXPECT_EQ(message([&] { excess_misfit(held_out(evidence), prediction(Eigen::Vector3d(1, 2, 3))); }),
              "a held-out prediction is [1 x 3]: it must have a row for each packing, at least one, and a "
              "column for "
              "each of 2 cells");
    EXPECT_EQ(message([&] { excess_misfit(held_out(evidence), prediction(Eigen::Vector2d(1, NAN))); }),
              "held-out cell `cell 0.1`: a prediction is not a number: leave that packing out, or the cell");
}

TEST(Decoys, PValueCountsThoseAsGood)
{
    EXPECT_NEAR(decoy_p_value(0.6, {0.1, 0.6, 0.9, NAN}), 3. / 5, 1e-15);
    EXPECT_NEAR(decoy_p_value(0.6, std::vector<double>(19, 0.0)), 0.05, 1e-15);
    EXPECT_EQ(decoy_p_value(0.6, {}), 1);
}

TEST(Decoys, PermuteConditionsAmongExperimentsOfOneKind)
{
    auto evidence = small_evidence(3, 2, 0);
    evidence.cells.push_back({"alone", 7, 5, {0}, 1});
    Eigen::VectorXd s = Eigen::VectorXd::LinSpaced(7, 0, 6);
    Eigen::VectorXd right(7);
    right << 2, 3, 4, 5, 0, 1, 6;
    EXPECT_EQ(permuted_signature(evidence.cells, s, 1), right);
    EXPECT_EQ(permuted_signature(evidence.cells, s, 3), s);
}

// The effect that made the gap closes it; smooth signatures of the same size rarely do.
TEST(Decoys, OwnSignatureClosesMoreThanOthers)
{
    auto all = small_evidence(6, 4, 2);
    Eigen::VectorXd const s = random_smooth_signatures(all.cells, 4 * all.predicted, 0.5, 1, 42)[0];
    all.measured += 0.1 * s;
    std::vector<int> in(16), out(8);
    std::iota(in.begin(), in.end(), 0);
    std::iota(out.begin(), out.end(), 16);
    auto const fitted = subset(all, in), others = subset(all, out);
    Projection const projection(fitted, make_floor(fitted).total());
    auto closure = [&](Eigen::VectorXd const& signature) {
        Signature on_fitted{"s", signature.head(16)}, on_others{"s", signature.tail(8)};
        return linear_closure(fitted, projection, others, on_fitted, on_others);
    };
    double const own = closure(s);
    EXPECT_GT(own, 0.95);
    std::vector<double> decoys;
    for (auto const& decoy : random_smooth_signatures(all.cells, s, 0.5, 19, 7)) {
        EXPECT_NEAR((decoy.array() / all.predicted.array()).matrix().norm(),
                    (s.array() / all.predicted.array()).matrix().norm(), 1e-9);
        decoys.push_back(closure(decoy));
    }
    EXPECT_NEAR(decoy_p_value(own, decoys), 0.05, 1e-12);
}
