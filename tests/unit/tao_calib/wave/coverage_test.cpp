#include "tests/unit/tao_calib/wave/coverage.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

class StatedIntervals : public ::testing::TestWithParam<char const*>
{
};

INSTANTIATE_TEST_SUITE_P(Coverage, StatedIntervals, ::testing::Values("quadratic", "rbf", "gaussian_process"),
                         [](auto const& info) { return info.param; });

TEST_P(StatedIntervals, HoldTheTruthWhateverTheReplicates)
{
    // 95 % intervals should hold 28 or 29 of 30 truths; with replicates they become narrower and go on to do
    // so. More campaigns: tests/bench/calibration.
    auto const single = coverage(GetParam(), 1, 15, 0), sixteen = coverage(GetParam(), 16, 15, 0);
    EXPECT_GE(single.held, 27) << single.share();
    EXPECT_GE(sixteen.held, 27) << sixteen.share();
    EXPECT_LT(sixteen.half_width(), 0.6 * single.half_width());
}

TEST(StatedIntervals, HoldTheTruthAfterASearchAsWell)
{
    // Points that a search chose: 200 intervals of 100 campaigns hold in 95 % (tests/bench/calibration),
    // here 30.
    auto const found = coverage("quadratic", 2, 15, 2);
    EXPECT_GE(found.held, 27) << found.share();
    EXPECT_LT(found.half_width(), 0.15);
}

} // namespace
} // namespace demens::tao_calib
