#include "demens/base/ids.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace {

using Apple = demens::Id<struct AppleTag>;
using Pear = demens::Id<struct PearTag>;

TEST(Id, StandsForItsKindOnly)
{
    static_assert(!std::is_convertible_v<Apple, Pear> && !std::is_constructible_v<Apple, Pear>);
    static_assert(!std::is_convertible_v<int, Apple> && std::is_constructible_v<Apple, std::uint32_t>);
    static_assert(sizeof(Apple) == sizeof(std::uint32_t));
    EXPECT_EQ(Apple{}.value, 0u);
    EXPECT_EQ(Apple{3}, Apple{3});
    EXPECT_NE(Apple{3}, Apple{4});
    EXPECT_LT(Apple{3}, Apple{4});
}

} // namespace
