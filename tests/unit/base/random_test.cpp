#include "demens/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;

TEST(Random, MixesAsPublished)
{
    // The generator SplitMix64 adds the golden gamma and mixes; its first numbers of seed 0 (Vigna,
    // splitmix64.c).
    constexpr std::uint64_t gamma = 0x9e3779b97f4a7c15ull;
    EXPECT_EQ(mix_bits(gamma), 0xe220a8397b1dcdafull);
    EXPECT_EQ(mix_bits(2 * gamma), 0x6e789e6aa1b965f4ull);
    EXPECT_EQ(mix_bits(3 * gamma), 0x06c45d188009454full);
    EXPECT_EQ(mix_bits(0), 0u);
}

TEST(Random, NumberNOfAStreamDependsOnSeedAndNOnly)
{
    RandomStream stream(42);
    for (std::uint64_t n = 0; n < 5; ++n)
        EXPECT_EQ(stream.next(), derive_seed(42, n));
    EXPECT_NE(derive_seed(1, 2), derive_seed(2, 1));
    EXPECT_NE(derive_seed(0, 0), 0u);
}

TEST(Random, UniformNumbersHaveTheirMomentsAndBounds)
{
    RandomStream stream(7);
    constexpr int count = 100'000;
    double sum = 0, squares = 0;
    for (int k = 0; k < count; ++k) {
        double const u = stream.uniform();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u, squares += u * u;
    }
    // Mean 1/2 and mean square 1/3; four standard errors, of 1/12 and 4/45.
    EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1.0 / 12 / count));
    EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
    for (int k = 0; k < 1000; ++k) {
        double const u = stream.uniform(-3, -1);
        ASSERT_TRUE(u >= -3 && u < -1);
        ASSERT_LT(stream.below(6), 6u);
    }
}

} // namespace
