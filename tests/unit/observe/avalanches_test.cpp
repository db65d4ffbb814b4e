#include "demens/observe/avalanches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;

TEST(Avalanches, AreFallsFromAMaximumToTheNextMinimum)
{
    //                                  0  1  2  3    4  5  6  7  8    9  10 11
    std::vector<double> const series = {3, 2, 4, 6, 5.5, 6, 3, 2, 2.5, 2, 4, 5};
    auto const found = observe::find_avalanches(series, 1);
    ASSERT_EQ(found.size(), 1u); // the fall at the beginning has no break, the rise at the end no rest
    EXPECT_EQ(found[0].break_at, 3u);
    EXPECT_EQ(found[0].rest_at, 7u);
    // With a smaller prominence, the dips on the way up and at the bottom are avalanches, too.
    auto const small = observe::find_avalanches(series, 0.5);
    ASSERT_EQ(small.size(), 3u);
    EXPECT_EQ(small[0].break_at, 3u);
    EXPECT_EQ(small[0].rest_at, 4u);
    EXPECT_EQ(small[1].break_at, 5u);
    EXPECT_EQ(small[1].rest_at, 7u);
    EXPECT_EQ(small[2].break_at, 8u);
    EXPECT_EQ(small[2].rest_at, 9u);
}

TEST(Avalanches, NeedARiseBeforeTheBreakAndAfterTheRest)
{
    EXPECT_TRUE(observe::find_avalanches({}, 1).empty());
    EXPECT_TRUE(observe::find_avalanches({5, 4, 3, 2}, 1).empty());
    EXPECT_TRUE(observe::find_avalanches({5, 7, 4, 4.5}, 1).empty());
    EXPECT_EQ(observe::find_avalanches({5, 7, 4, 5}, 1).size(), 1u);
}

TEST(Avalanches, StatisticsOfASawtoothAreThoseOfItsTeeth)
{
    // 12 teeth: up from 10 in 9 steps, down in one; every third tooth 3 higher than the others.
    std::vector<double> series;
    for (int tooth = 0; tooth < 12; ++tooth)
        for (int k = 0; k <= 9; ++k)
            series.push_back(10 + k * (tooth % 3 == 1 ? 12.0 : 9.0) / 9);
    series.insert(series.end(), {10, 15});
    auto const statistics = observe::avalanche_statistics(series, 0.5, 2.0);
    EXPECT_EQ(statistics.count, 12u);
    EXPECT_DOUBLE_EQ(statistics.break_mean.value, 20);
    EXPECT_DOUBLE_EQ(statistics.rest_mean.value, 10);
    EXPECT_DOUBLE_EQ(statistics.fall_mean.value, 10);
    // Four breaks 2 above their mean, eight 1 below: sum of squares 24 over 11.
    EXPECT_DOUBLE_EQ(statistics.break_sd.value, std::sqrt(24.0 / 11));
    EXPECT_DOUBLE_EQ(statistics.break_mean.standard_error, std::sqrt(24.0 / 11 / 12));
    EXPECT_DOUBLE_EQ(statistics.rest_sd.value, 0);
    EXPECT_DOUBLE_EQ(statistics.rate.value, 0.2); // one in 10 steps of 0.5
    EXPECT_DOUBLE_EQ(statistics.rate.standard_error, 0);
}

TEST(Avalanches, AnEvenFlowHasItsMeanAsBreakAndRest)
{
    std::vector<double> series;
    for (int k = 0; k < 1000; ++k)
        series.push_back(5 + 0.01 * std::sin(2 * std::numbers::pi * k / 50));
    auto const statistics = observe::avalanche_statistics(series, 1, 0.1);
    EXPECT_EQ(statistics.count, 0u);
    EXPECT_NEAR(statistics.break_mean.value, 5, 1e-12);
    EXPECT_EQ(statistics.rest_mean.value, statistics.break_mean.value);
    EXPECT_EQ(statistics.fall_mean.value, 0);
    EXPECT_EQ(statistics.rate.value, 0);
}

TEST(Avalanches, OneAvalancheIsKnownNoBetterThanTheSeriesSpreads)
{
    std::vector<double> const series = {0, 2, 0, 2};
    auto const statistics = observe::avalanche_statistics(series, 1, 1);
    EXPECT_EQ(statistics.count, 1u);
    EXPECT_DOUBLE_EQ(statistics.break_mean.value, 2);
    EXPECT_DOUBLE_EQ(statistics.break_mean.standard_error, std::sqrt(4.0 / 3));
    EXPECT_DOUBLE_EQ(statistics.rate.value, 1.0 / 3);
}

} // namespace
