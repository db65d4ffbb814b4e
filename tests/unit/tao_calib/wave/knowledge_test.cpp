#include "demens/base/not_a_number.hpp"
#include "tao_calib/summary.hpp"
#include "tao_calib/wave/tolerance_region.hpp"
#include "tao_calib/wave/tradeoff.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

//! Two factors in [0, 1], responses without scatter, targets for the first of them, 16 runs of a design.
StandIn design_of(StandIn::Formula const& formula, rig::RigInfo const& rig,
                  std::vector<double> const& targets, double tolerance)
{
    StandIn stand_in(formula, std::vector<double>(rig.responses.size(), 0.0));
    auto& input = stand_in.campaign.input;
    input.factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
    input.surrogate.kind = ensemble::SurrogateChoice::gaussian_process;
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    for (std::size_t t = 0; t < targets.size(); ++t)
        experiment.targets.push_back(
            {rig.responses[t].name, static_cast<int>(t), targets[t], 1, 0.02, tolerance});
    input.experiments = {experiment};
    input.design.points = 16;
    input.stop.waves = 1;
    input.stop.runs = 40;
    stand_in.advance();
    return stand_in;
}

ToleranceRegion region_of(StandIn const& stand_in)
{
    Assessment const assessment(stand_in.campaign, pounders());
    return tolerance_region(assessment, factor_uncertainty(assessment, 1), 1);
}

TEST(ToleranceRegion, IsTheBandWhereTheResponseIsMet)
{
    // a within 0.4 +- 0.1, b anything: one part of a fifth of the range.
    static auto const rig = response_names({"y"});
    auto const region = region_of(design_of(
        [](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; }, rig, {0.4}, 0.1));
    EXPECT_TRUE(region.by_tolerance);
    EXPECT_NEAR(region.share, 0.2, 0.03);
    ASSERT_EQ(region.parts.size(), 1u);
    EXPECT_NEAR(region.parts[0].lower[0], 0.3, 0.01);
    EXPECT_NEAR(region.parts[0].upper[0], 0.5, 0.01);
    EXPECT_LT(region.parts[0].lower[1], 0.05);
    EXPECT_GT(region.parts[0].upper[1], 0.95);
}

TEST(ToleranceRegion, SaysThatThereAreTwoParts)
{
    // (a - 1/2)^2 within 0.09 +- 0.02: a from 0.168 to 0.235 and from 0.765 to 0.832, each a fifteenth.
    static auto const rig = response_names({"y"});
    auto const region = region_of(design_of(
        [](std::vector<double> const& f, int) { return std::vector<double>{(f[0] - 0.5) * (f[0] - 0.5)}; },
        rig, {0.09}, 0.02));
    ASSERT_EQ(region.parts.size(), 2u);
    EXPECT_NEAR(region.share, 0.134, 0.03);
    double const left = std::min(region.parts[0].upper[0], region.parts[1].upper[0]);
    double const right = std::max(region.parts[0].lower[0], region.parts[1].lower[0]);
    EXPECT_NEAR(left, 0.5 - std::sqrt(0.07), 0.02);
    EXPECT_NEAR(right, 0.5 + std::sqrt(0.07), 0.02);
}

TEST(ToleranceRegion, SaysThatThereIsNone)
{
    static auto const rig = response_names({"y", "z"});
    auto stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0], f[0]};
        },
        rig, {0.2, 0.8}, 0.1);
    EXPECT_TRUE(region_of(stand_in).parts.empty());
    stand_in.advance();
    EXPECT_NE(summary(stand_in.campaign).find("predicted within every tolerance: nowhere"), std::string::npos)
        << summary(stand_in.campaign);
}

TEST(Tradeoff, NamesThePairAndTheResponseThatSeparatesIt)
{
    // Only a + b is a target. The rig also gives a constant and a - b, which tells them apart.
    static auto const rig = response_names({"sum", "constant", "difference"});
    auto stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], 7, f[0] - f[1]};
        },
        rig, {1.0}, not_a_number);
    Assessment const assessment(stand_in.campaign, pounders());
    auto const pairs = tradeoffs(stand_in.campaign, assessment, factor_uncertainty(assessment, 1));
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].first, 0);
    EXPECT_EQ(pairs[0].second, 1);
    EXPECT_LT(pairs[0].correlation, -0.95);
    EXPECT_EQ(pairs[0].response, 2);
    EXPECT_GT(pairs[0].variance_removed, 0.95);
    stand_in.advance();
    EXPECT_NE(summary(stand_in.campaign).find("a and b trade off"), std::string::npos);
    EXPECT_NE(summary(stand_in.campaign).find("measuring bench.difference would take away"),
              std::string::npos)
        << summary(stand_in.campaign);
}

TEST(Tradeoff, SuggestsNoResponseThatCannotBeMeasured)
{
    // As above, but what separates the pair is the standard error of something else.
    static auto const rig = [] {
        auto info = response_names({"sum", "constant", "difference"});
        info.responses[2].kind = rig::ResponseKind::accuracy;
        return info;
    }();
    auto const stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], 7, f[0] - f[1]};
        },
        rig, {1.0}, not_a_number);
    Assessment const assessment(stand_in.campaign, pounders());
    auto const pairs = tradeoffs(stand_in.campaign, assessment, factor_uncertainty(assessment, 1));
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].response, -1);
}

TEST(Tradeoff, IsNoneWhereTheTargetsDetermineTheFactors)
{
    static auto const rig = response_names({"sum", "difference"});
    auto const stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        rig, {1.0, 0.1}, not_a_number);
    Assessment const assessment(stand_in.campaign, pounders());
    EXPECT_TRUE(tradeoffs(stand_in.campaign, assessment, factor_uncertainty(assessment, 1)).empty());
}

TEST(Region90, IsTheEllipseOfLinearLeastSquares)
{
    // y = (a + b, a - b) with errors of 0.02: chi2 = 2 |x - x0|^2/0.02^2 up to 4.605.
    static auto const rig = response_names({"sum", "difference"});
    auto const stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        rig, {1.0, 0.1}, not_a_number);
    Assessment const assessment(stand_in.campaign, pounders());
    auto const known = factor_uncertainty(assessment, 1);
    double const radius = std::sqrt(4.605170 / 2) * 0.02;
    auto inside = [&](double share) {
        return misfit(assessment, known.target_noise, Eigen::VectorXd{{0.55 + share * radius, 0.45}}) <=
               known.region_90;
    };
    EXPECT_TRUE(inside(0.98));
    EXPECT_FALSE(inside(1.02));
}

TEST(OutOfReach, SaysByHowMuch)
{
    // Responses go up to 1; the target is 1.4.
    static auto const rig = response_names({"y"});
    auto stand_in = design_of([](std::vector<double> const& f, int) { return std::vector<double>{f[0]}; },
                              rig, {1.4}, not_a_number);
    stand_in.advance();
    double const distance = stand_in.stored("optimum/out_of_reach").front();
    EXPECT_GT(distance, 0.4 - 1e-9);
    EXPECT_LT(distance, 0.5);
    EXPECT_NE(summary(stand_in.campaign)
                  .find("no point, in the mean of its runs, reached the target of bench.y: it is above"),
              std::string::npos);
}

TEST(Summary, WarnsOfAResponseThatNothingActsOn)
{
    static auto const rig = response_names({"y", "dead"});
    auto stand_in = design_of(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0], 3};
        },
        rig, {0.5, 3}, not_a_number);
    stand_in.advance();
    EXPECT_NE(summary(stand_in.campaign).find("bench.dead is the same in all runs"), std::string::npos)
        << summary(stand_in.campaign);
}

} // namespace
} // namespace demens::tao_calib
