#include "ensemble/fit_quality.hpp"
#include "ensemble/verdict.hpp"
#include "tests/mpi/formula_rig.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace demens::ensemble {
namespace {

using namespace demens::test;

//! Targets 1.5 +- 0.05 in scales of 0.1, and 0.5 in scales of 0.2 without a tolerance.
CampaignInput input_with_tolerance(double second_tolerance)
{
    auto input = CampaignInput::from_text(formula_campaign(), "test", formula_rigs());
    input.experiments[1].targets[0].tolerance = second_tolerance;
    return input;
}

TEST(FitQuality, IsToldInTolerancesWhereEveryTargetHasOne)
{
    auto const quality = fit_quality(input_with_tolerance(0.1), {1.53, 0.48});
    EXPECT_EQ(quality.yardstick, Yardstick::tolerance);
    EXPECT_NEAR(quality.largest, 0.6, 1e-9); // 0.03 of 0.05
    EXPECT_EQ(quality.worst, "slow.length_m");
    EXPECT_NEAR(quality.root_mean_square, std::sqrt((0.09 + 0.01) / 2), 1e-9); // 0.3 and 0.1 scales
    EXPECT_EQ(headline(quality), "within 0.6 tolerances of all targets");
}

TEST(FitQuality, IsToldInScalesWhereATargetHasNoTolerance)
{
    auto const input = input_with_tolerance(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(headline(fit_quality(input, {1.5, 0.4})), "within 0.5 scales of all targets");
    EXPECT_EQ(headline(fit_quality(input, {1.5, -17.5})), "up to 90 scales off the targets: fast.map_value");
}

TEST(FitQuality, NeverSaysLessThanItIs)
{
    FitQuality quality{.largest = 0.6041, .worst = "a.b", .targets = 1};
    EXPECT_EQ(headline(quality), "within 0.61 scales of the target");
    quality.largest = 1e-9;
    EXPECT_EQ(headline(quality), "within a hundredth of a scale of the target");
    quality.largest = 89184.3;
    EXPECT_EQ(headline(quality), "up to 8.92e+04 scales off the target: a.b");
}

TEST(Verdict, StatesNoIntervalOfMissedTargetsButWithTheNoiseEnlarged)
{
    EXPECT_FALSE(states_interval(Verdict::misfit, 1));
    EXPECT_TRUE(states_interval(Verdict::misfit, 2.5));
    EXPECT_TRUE(states_interval(Verdict::determined, 1));
    EXPECT_FALSE(states_interval(Verdict::extrapolated, 2.5));
}

} // namespace
} // namespace demens::ensemble
