#include "tao_calib/wave/uncertainty.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

//! Two or more factors in [0, 1] and linear responses without scatter, all with measurement errors of `sd`.
StandIn linear(StandIn::Formula const& formula, rig::RigInfo const& rig, std::vector<double> const& targets,
               double sd)
{
    StandIn stand_in(formula, std::vector<double>(targets.size(), 0.0));
    auto& input = stand_in.campaign.input;
    input.factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        ensemble::Target target;
        target.response = rig.responses[t].name;
        target.response_index = static_cast<int>(t);
        target.value = targets[t], target.scale = 1, target.sd = sd, target.tolerance = none;
        experiment.targets.push_back(target);
    }
    input.experiments = {experiment};
    input.design.points = 10;
    input.stop.runs = 30;
    stand_in.advance();
    return stand_in;
}

FactorUncertainty known(StandIn const& stand_in)
{
    Assessment const assessment(stand_in.campaign, pounders());
    return factor_uncertainty(assessment, 1);
}

TEST(FactorUncertainty, IsThatOfLinearLeastSquares)
{
    // y = (a + b, a - b) with errors of 0.05: variances 0.05^2/2, no correlation, intervals +-1.96 standard
    // errors.
    auto const rig = response_names({"sum", "difference"});
    auto const stand_in = linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        rig, {1.0, 0.1}, 0.05);
    auto const result = known(stand_in);
    double const error = 0.05 / std::sqrt(2.0);
    for (int j = 0; j < 2; ++j) {
        double const centre = j == 0 ? 0.55 : 0.45;
        EXPECT_NEAR(result.standard_errors[j], error, 0.05 * error);
        EXPECT_NEAR(result.intervals(j, 0), centre - std::sqrt(3.84) * error, 0.001);
        EXPECT_NEAR(result.intervals(j, 1), centre + std::sqrt(3.84) * error, 0.001);
        EXPECT_EQ(result.verdicts[j], Verdict::determined);
    }
    EXPECT_NEAR(result.correlations(0, 1), 0, 0.1);
    EXPECT_EQ(result.correlations(0, 0), 1);
}

TEST(FactorUncertainty, SaysWhatTheTargetsDoNotDetermine)
{
    // Only a acts: b keeps its whole range, and its standard error is that of a uniform distribution.
    auto const rig = response_names({"y"});
    auto const result = known(linear(
        [](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {0.4}, 0.05));
    EXPECT_EQ(result.verdicts[0], Verdict::determined);
    EXPECT_EQ(result.verdicts[1], Verdict::not_determined);
    EXPECT_NEAR(result.intervals(1, 0), 0, 1e-3);
    EXPECT_NEAR(result.intervals(1, 1), 1, 1e-3);
    EXPECT_NEAR(result.standard_errors[1], 1 / std::sqrt(12.0), 0.02);
}

TEST(FactorUncertainty, SeesFactorsThatActOnlyTogether)
{
    // Only a + b = 1 is known: each factor can be anything, but they are tied to each other.
    auto const rig = response_names({"y"});
    auto const result =
        known(linear([](std::vector<double> const& f, int) { return std::vector<double>{f[0] + f[1]}; }, rig,
                     {1.0}, 0.02));
    EXPECT_EQ(result.verdicts[0], Verdict::not_determined);
    EXPECT_EQ(result.verdicts[1], Verdict::not_determined);
    EXPECT_LT(result.correlations(0, 1), -0.98);
}

TEST(FactorUncertainty, CountsAMisfitThatCannotBeRemovedAsNoise)
{
    // Three measurements of a alone, 0.3, 0.5 and 0.7 with stated errors of 0.01, contradict each other. chi2
    // is 2 (0.2/0.01)^2 = 800 with one degree of freedom for two factors, so that the noise is 0.01 sqrt(800)
    // = 0.283.
    auto const rig = response_names({"first", "second", "third"});
    auto const result = known(linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0], f[0], f[0]};
        },
        rig, {0.3, 0.5, 0.7}, 0.01));
    for (double noise : result.target_noise)
        EXPECT_NEAR(noise, 0.01 * std::sqrt(800.0), 1e-4);
    EXPECT_NEAR(result.intervals(0, 1) - result.intervals(0, 0), 2 * std::sqrt(3.84 / 3) * 0.283, 0.01);
}

TEST(FactorUncertainty, EndsAtTheBounds)
{
    auto const rig = response_names({"y"});
    auto const result = known(linear(
        [](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {0.95}, 0.1));
    EXPECT_NEAR(result.intervals(0, 0), 0.95 - std::sqrt(3.84) * 0.1, 0.002);
    EXPECT_EQ(result.intervals(0, 1), 1.0);
}

TEST(FactorUncertainty, GivesTheSameBitsAgain)
{
    auto stand_in = draw_down_campaign({0.9, 0.6, 0.25}, {0, 0, 0, 0}, 1);
    stand_in.advance();
    auto const first = known(stand_in), second = known(stand_in);
    EXPECT_EQ(first.intervals, second.intervals);
    EXPECT_EQ(first.standard_errors, second.standard_errors);
    EXPECT_EQ(first.correlations, second.correlations);
}

} // namespace
} // namespace demens::tao_calib
