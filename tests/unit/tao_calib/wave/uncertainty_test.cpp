#include "tao_calib/wave/uncertainty.hpp"

#include "demens/base/not_a_number.hpp"
#include "tao_calib/summary.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

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
        target.value = targets[t], target.scale = 1, target.sd = sd, target.tolerance = not_a_number;
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
    // The misfit comes first, as it is: chi2 of 800 on one degree of freedom has p = 1e-175.
    EXPECT_NEAR(result.fit.chi_square, 800, 1);
    EXPECT_EQ(result.fit.degrees, 1);
    EXPECT_NEAR(std::log10(result.fit.p_value), -175.3, 0.3);
    EXPECT_NEAR(result.fit.inflation, std::sqrt(800.0), 0.02);
    EXPECT_EQ(result.verdicts[0], Verdict::misfit);
    EXPECT_NEAR(result.intervals(0, 1) - result.intervals(0, 0), 2 * std::sqrt(3.84 / 3) * 0.283, 0.01);
}

TEST(FactorUncertainty, DeterminesNothingWhereTargetsAreMissed)
{
    // As many targets as factors, both out of reach: a + b up to 2, a - b up to 1, 20 errors away.
    auto const rig = response_names({"sum", "difference"});
    auto const result = known(linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        rig, {3.0, 0.0}, 0.05));
    EXPECT_NEAR(result.fit.chi_square, 400, 4);
    EXPECT_EQ(result.fit.degrees, 2);
    EXPECT_NEAR(std::log10(result.fit.p_value), -200 / std::log(10.0), 1);
    EXPECT_EQ(result.fit.inflation, 1);
    for (int j = 0; j < 2; ++j) {
        EXPECT_EQ(result.verdicts[j], Verdict::misfit);
        EXPECT_EQ(result.on_bounds[j], OnBound::upper);
    }
}

//! One factor with its bounds, y = a with a target of 0.5 +- 0.05 unless said otherwise.
FactorUncertainty known_within(ensemble::Factor const& factor, double target = 0.5, double sd = 0.05)
{
    static auto const rig = response_names({"y"});
    auto stand_in = linear([](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig,
                           {target}, sd);
    auto again = stand_in;
    again.campaign.waves.clear();
    again.campaign.input.factors = {factor};
    again.advance();
    return known(again);
}

TEST(FactorUncertainty, JudgesTheSameWhateverTheBounds)
{
    // 0.5 +- 1.96 x 0.05: 19.6 % of the value. Bounds that cut the interval, or are far away, change nothing.
    for (auto const& [lower, upper] :
         {std::pair{0.3, 0.7}, std::pair{0.01, 4.0}, std::pair{0.44, 0.57}, std::pair{0.49, 0.9}}) {
        auto const result = known_within({"a", "a", lower, upper});
        EXPECT_EQ(result.verdicts[0], Verdict::determined) << lower << " to " << upper;
        EXPECT_NEAR(result.spreads[0], 0.196, 0.004) << lower << " to " << upper;
        EXPECT_GE(result.intervals(0, 0), lower);
        EXPECT_LE(result.intervals(0, 1), upper);
    }
    // 0.5 +- 1.96 x 0.2 is not determined, nor within bounds that look like knowledge.
    for (auto const& [lower, upper] : {std::pair{0.01, 4.0}, std::pair{0.45, 0.55}})
        EXPECT_EQ(known_within({"a", "a", lower, upper}, 0.5, 0.2).verdicts[0], Verdict::not_determined)
            << lower << " to " << upper;
}

TEST(FactorUncertainty, JudgesTwoFactorsTheSameWithinBoundsThatCutBoth)
{
    // a + b and a - b with errors of 0.05: each +- 1.96 x 0.05/sqrt(2), of about 0.5; 13.9 % of it.
    auto const rig = response_names({"sum", "difference"});
    auto stand_in = linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        rig, {1.0, 0.0}, 0.05);
    stand_in.campaign.waves.clear();
    stand_in.campaign.input.factors = {{"a", "a", 0.48, 0.53}, {"b", "b", 0.1, 0.9}};
    stand_in.advance();
    auto const result = known(stand_in);
    EXPECT_NEAR(result.spreads[0], 0.139, 0.005);
    EXPECT_NEAR(result.spreads[1], 0.139, 0.005);
    EXPECT_EQ(result.intervals(0, 1), 0.53);
}

TEST(FactorUncertainty, JudgesALogarithmicFactorInItsLogarithm)
{
    // y = ln E known to 0.56 (1.96 sd of 1.1): E within a factor of 3, nine times from end to end.
    static auto const rig = response_names({"y"});
    auto stand_in =
        linear([](std::vector<double> const& f, int) { return std::vector<double>{std::log(f[0])}; }, rig,
               {std::log(3e7)}, std::log(3.0) / std::sqrt(3.84));
    stand_in.campaign.waves.clear();
    stand_in.campaign.input.factors = {{"E", "E", 1e6, 1e9, true}};
    stand_in.advance();
    auto const result = known(stand_in);
    EXPECT_NEAR(result.spreads[0], 2, 0.02);
    EXPECT_NEAR(result.intervals(0, 1) / result.intervals(0, 0), 9, 0.1);
    EXPECT_EQ(result.verdicts[0], Verdict::not_determined);
}

TEST(FactorUncertainty, DeterminesNoFactorWhoseSignIsOpen)
{
    // Only a^2 + b^2 = 0.25 and b = 0.3 are known: a = +-0.4.
    auto const rig = response_names({"square", "b"});
    auto stand_in = linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] * f[0] + f[1] * f[1], f[1]};
        },
        rig, {0.25, 0.3}, 0.01);
    stand_in.campaign.waves.clear();
    stand_in.campaign.input.factors = {{"a", "a", -1.0, 1.0}, {"b", "b", 0.1, 1.0}};
    stand_in.advance();
    auto const result = known(stand_in);
    EXPECT_NEAR(result.intervals(0, 0), -0.42, 0.02);
    EXPECT_NEAR(result.intervals(0, 1), 0.42, 0.02);
    EXPECT_EQ(result.verdicts[0], Verdict::limit);
    EXPECT_TRUE(std::isnan(result.spreads[0]));
    EXPECT_EQ(result.verdicts[1], Verdict::determined);
}

TEST(FactorUncertainty, KnowsOnlyALimitOfAFactorCompatibleWithZero)
{
    EXPECT_EQ(known_within({"a", "a", 0.0, 1.0}, 0.02, 0.05).verdicts[0], Verdict::limit);
    EXPECT_EQ(known_within({"a", "a", -1.0, 1.0}, 0.02, 0.05).verdicts[0], Verdict::limit);
    EXPECT_EQ(known_within({"a", "a", 0.0, 1.0}, 0.5, 2.0).verdicts[0], Verdict::not_determined);
}

TEST(FactorUncertainty, SaysThatTheEstimateIsOnABound)
{
    // The target is one error beyond the upper bound: that may be chance, but the bound is in the way.
    auto const result = known_within({"a", "a", 0.3, 0.45});
    EXPECT_EQ(result.on_bounds[0], OnBound::upper);
    EXPECT_NE(result.verdicts[0], Verdict::determined);
    EXPECT_GT(result.fit.p_value, 0.1);
}

TEST(FactorUncertainty, DeterminesNothingByExtrapolationToWhereRunsFail)
{
    // y = 1/(1 - a) up to a = 0.5, where the flow stops; the target is reached at 0.6.
    static auto const rig = response_names({"y"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            if (f[0] > 0.5)
                throw std::runtime_error("it does not flow");
            return std::vector<double>{1 / (1 - f[0])};
        },
        {0.0});
    stand_in.campaign.input =
        linear([](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {2.5}, 0.05)
            .campaign.input;
    stand_in.campaign.input.factors = {{"a", "a", 0.0, 1.0}};
    stand_in.campaign.input.design.points = 20;
    stand_in.advance();
    auto const result = known(stand_in);
    EXPECT_GT(result.estimate.unit[0], 0.5);
    EXPECT_EQ(result.verdicts[0], Verdict::extrapolated);
    // No number that looks like knowledge is stated or stored: not the interval, nor that the target is met.
    EXPECT_FALSE(result.has_support);
    EXPECT_TRUE(std::isnan(result.intervals(0, 0)) && std::isnan(result.intervals(0, 1)));
    EXPECT_TRUE(std::isnan(result.standard_errors[0]) && std::isnan(result.spreads[0]));
    stand_in.campaign.input.stop.waves = 0;
    stand_in.advance();
    for (auto const* path : {"optimum/estimate", "optimum/estimate_responses", "optimum/p_value",
                             "optimum/factor_interval", "optimum/factor_spread"})
        EXPECT_TRUE(std::isnan(stand_in.stored(path).front())) << path;
    EXPECT_THROW((void)stand_in.stored("region/share"), std::out_of_range);
    auto const text = summary(stand_in.campaign);
    EXPECT_NE(text.find("whether the targets can be met is not known"), std::string::npos) << text;
    EXPECT_NE(text.find("none             -  not determined: extrapolated to where runs fail"),
              std::string::npos)
        << text;
}

TEST(FactorUncertainty, DeterminesNothingBeyondAllRuns)
{
    // y = a simulated from 0.1 to 0.4, the target at 0.9: a line tells it exactly, and no run supports it.
    static auto const rig = response_names({"y"});
    auto stand_in =
        linear([](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {0.9}, 0.01);
    auto run_within = [&](double upper) {
        stand_in.campaign.input.factors = {{"a", "a", 0.0, 1.0}};
        double place = 0.1;
        for (auto& run : stand_in.campaign.waves.front().runs) {
            run.factors = {place};
            run.responses = {place};
            place += (upper - 0.1) / 9;
        }
        return known(stand_in);
    };
    auto const beyond = run_within(0.4);
    EXPECT_NEAR(beyond.estimate.unit[0], 0.9, 1e-6);
    EXPECT_EQ(beyond.verdicts[0], Verdict::beyond_runs);
    EXPECT_TRUE(std::isnan(beyond.intervals(0, 0)));
    // As near to the runs as the bounds of a Latin hypercube are to its points.
    EXPECT_EQ(run_within(0.85).verdicts[0], Verdict::determined);
}

TEST(FactorUncertainty, TakesChi2WhereChi2IsLeast)
{
    // Two measurements of a, 0.50 +- 0.005 and 0.60 +- 0.1, the second one weighed by far more in the
    // objective: the estimate is the weighted mean 0.50025, its interval +- 1.96 x 0.004994.
    auto const rig = response_names({"first", "second"});
    auto stand_in = linear(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0], f[0]};
        },
        rig, {0.5, 0.6}, 0.005);
    auto& targets = stand_in.campaign.input.experiments.front().targets;
    targets[0].scale = 0.1, targets[1].scale = 0.005, targets[1].sd = 0.1;
    stand_in.campaign.input.factors = {{"a", "a", 0.0, 1.0}};
    for (auto& run : stand_in.campaign.waves.front().runs)
        run.factors.resize(1);
    Assessment const assessment(stand_in.campaign, pounders());
    EXPECT_NEAR(assessment.minima().front().point[0], 0.6, 0.001);
    auto const result = factor_uncertainty(assessment, 1);
    double const weight = 1 / (0.005 * 0.005) + 1 / (0.1 * 0.1);
    double const mean = (0.5 / (0.005 * 0.005) + 0.6 / (0.1 * 0.1)) / weight;
    EXPECT_NEAR(result.estimate.unit[0], mean, 1e-5);
    EXPECT_NEAR(result.intervals(0, 0), mean - std::sqrt(3.84 / weight), 1e-4);
    EXPECT_NEAR(result.intervals(0, 1), mean + std::sqrt(3.84 / weight), 1e-4);
    EXPECT_EQ(result.fit.inflation, 1);
}

TEST(FactorUncertainty, CountsAnErrorKnownFromFewRunsAsLargerByStudentsT)
{
    // Ten scattering runs, polynomials: n - p degrees of freedom. t is 2.364624 for seven, 2.306004 for
    // eight.
    static auto const rig = response_names({"y"});
    StandIn stand_in([](std::vector<double> const& f, int) { return std::vector<double>{3 * f[0]}; }, {0.3});
    stand_in.campaign.input =
        linear([](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {1.5}, 0.05)
            .campaign.input;
    stand_in.campaign.input.surrogate.kind = ensemble::SurrogateChoice::quadratic;
    stand_in.campaign.input.factors = {{"a", "a", 0.0, 1.0}};
    stand_in.advance();
    Assessment const assessment(stand_in.campaign, pounders());
    double const degrees = assessment.surrogate(0).degrees_of_freedom();
    ASSERT_TRUE(degrees == 7 || degrees == 8) << degrees;
    VectorXd const place{{0.5}};
    double const larger = (degrees == 7 ? 2.364624 : 2.306004) / 1.959964;
    EXPECT_NEAR(target_noise(assessment, place)[0],
                std::hypot(0.05, larger * assessment.prediction_sd(place)[0]), 1e-6);
}

TEST(FactorUncertainty, DoesNotUseASurrogateThatIsNoBetterThanTheMean)
{
    // The second response is scatter alone: it must neither narrow nor shift what the first one tells.
    static auto const rig = response_names({"y", "scatter"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0], 0.5};
        },
        {0.0, 0.2});
    stand_in.campaign.input = linear(
                                  [](std::vector<double> const& f, int) {
                                      return std::vector<double>{f[0], 0.5};
                                  },
                                  rig, {0.5, 0.7}, 0.05)
                                  .campaign.input;
    stand_in.campaign.input.surrogate.kind = ensemble::SurrogateChoice::quadratic;
    stand_in.campaign.input.design.points = 40;
    stand_in.campaign.input.factors = {{"a", "a", 0.0, 1.0}};
    stand_in.advance();
    Assessment const assessment(stand_in.campaign, pounders());
    ASSERT_FALSE(assessment.informs(1));
    auto const result = factor_uncertainty(assessment, 1);
    EXPECT_NEAR(result.estimate.unit[0], 0.5, 1e-6);
    EXPECT_NEAR(result.intervals(0, 1), 0.5 + std::sqrt(3.84) * 0.05, 0.002);
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
