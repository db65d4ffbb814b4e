#include "ensemble/curve/curve_target.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::ensemble {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

//! A balance that says 2 - t at 0, 0.1, ... 1, in two windows of half of it.
CurveTarget measured()
{
    CurveTarget target{.name = "mass"};
    for (int k = 0; k <= 10; ++k) {
        target.curve.axis.push_back(0.1 * k);
        target.curve.values.push_back(2 - 0.1 * k);
    }
    target.windows = {{.name = "early", .from = 0, .to = 0.5, .first = 0, .end = 5},
                      {.name = "late", .from = 0.5, .to = 1, .first = 5, .end = 11}};
    return target;
}

//! A run whose mass is 2 - (t - delay) from there on, until it ends, each 0.05 s.
rig::RunResult run(double delay, double end)
{
    rig::RunResult result;
    result.series = {{"time", "mass"}, {"s", "kg"}, {{}, {}}};
    for (int k = 0; 0.05 * k <= end + 1e-9; ++k) {
        result.series.columns[0].push_back(0.05 * k);
        result.series.columns[1].push_back(2 - std::max(0.0, 0.05 * k - delay));
    }
    return result;
}

TEST(CurveTarget, IsMetByTheMeansOfItsWindows)
{
    auto const target = measured();
    // Points on the axis count with half of the way to their neighbours: 0 to 0.45, 0.45 to 1.
    EXPECT_THAT(responses_of(target, run(0, 2)),
                ElementsAre(DoubleNear(2 - 0.2 - 0.0222222222, 1e-9), DoubleNear(2 - 0.7272727273, 1e-9)));
    // A delay of a step of 0.1: one point less has fallen.
    EXPECT_THAT(responses_of(target, run(0.1, 2))[1], DoubleNear(2 - 0.6272727273, 1e-9));
}

TEST(CurveTarget, AFreeShiftIsFoundAndToldBesides)
{
    auto target = measured();
    target.shift = CurveShift::free;
    target.largest_shift = 0.5;
    auto const met = responses_of(measured(), run(0, 2));
    for (double const delay : {0.0, 0.237, 0.4999}) {
        auto const responses = responses_of(target, run(delay, 2));
        ASSERT_EQ(responses.size(), 3u);
        EXPECT_NEAR(responses[0], met[0], 1e-3) << delay; // but for the corner at its beginning
        EXPECT_NEAR(responses[1], met[1], 1e-3) << delay;
        EXPECT_NEAR(responses[2], delay, 2e-3) << delay;
    }
    EXPECT_NEAR(responses_of(target, run(0.9, 2))[2], 0.5, 1e-12); // no further
    auto const infos = responses_of(target, "s", "kg");
    EXPECT_EQ(infos[1].name, "mass_late");
    EXPECT_EQ(infos[1].units, "kg");
    EXPECT_EQ(infos[2].name, "mass_shift");
    EXPECT_EQ(infos[2].units, "s");
}

TEST(CurveTarget, ASeriesStaysAsItIsAtItsEnd)
{
    double const end = 0.5; // at 1.5 kg
    EXPECT_NEAR(responses_of(measured(), run(0, end))[1], 1.5, 1e-12);
}

TEST(CurveTarget, AProfileHasNoValueBeyondItsEndsOrInAGap)
{
    auto target = measured();
    target.is_profile = true;
    target.name = "heap";
    rig::RunResult result;
    double const none = std::nan("");
    result.profiles = {
        {"heap", "", {{"x", "height"}, {"m", "m"}, {{0, 0.2, 0.4, 0.6}, {2, 1.8, none, 1.4}}}}};
    auto const responses = responses_of(target, result);
    EXPECT_NEAR(responses[0], responses_of(measured(), run(0, 2))[0], 1e-12); // a gap is gone straight over
    EXPECT_TRUE(std::isnan(responses[1]));
    target.name = "slope";
    EXPECT_TRUE(std::isnan(responses_of(target, result)[0]));
}

TEST(CurveTarget, TheLaterOfTwoStagesCountsWhereTheyMeet)
{
    rig::Series const series{{"time", "mass"}, {"s", "kg"}, {{0, 1, 1, 2}, {5, 4, 3, 2}}};
    auto const curve = simulated_curve(measured(), series, {});
    EXPECT_THAT(curve.axis, ElementsAre(0, 1, 2));
    EXPECT_THAT(curve.values, ElementsAre(5, 3, 2));
    EXPECT_THAT(simulated_curve({.name = "none"}, series, {}).axis, IsEmpty());
}

} // namespace
} // namespace demens::ensemble
