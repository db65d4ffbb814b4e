#include "tao_calib/wave/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace demens::tao_calib {
namespace {

TEST(GoodnessOfFit, HasTheValuesOfTables)
{
    // Chi-square of 110 on 2 degrees of freedom: p = exp(-55), and noise sqrt(55) times as large.
    auto const contradiction = goodness_of_fit(110, 4, 2);
    EXPECT_EQ(contradiction.degrees, 2);
    EXPECT_NEAR(contradiction.p_value / std::exp(-55.0), 1, 1e-10);
    EXPECT_NEAR(contradiction.inflation, std::sqrt(55.0), 1e-12);
    EXPECT_TRUE(misses_targets(contradiction.p_value));
    // 3.841 on one degree: 0.05. No degree left: all targets, and no reason to enlarge anything.
    EXPECT_NEAR(goodness_of_fit(3.841459, 3, 2).p_value, 0.05, 1e-7);
    EXPECT_EQ(goodness_of_fit(9.21034, 2, 3).degrees, 2);
    EXPECT_NEAR(goodness_of_fit(9.21034, 2, 3).p_value, 0.01, 1e-7);
    EXPECT_EQ(goodness_of_fit(9.21034, 2, 3).inflation, 1);
    EXPECT_EQ(goodness_of_fit(0, 3, 2).p_value, 1);
}

} // namespace
} // namespace demens::tao_calib
