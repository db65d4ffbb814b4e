#include "demens/base/text/wrap.hpp"

#include <gtest/gtest.h>

namespace demens::text {
namespace {

TEST(Wrapped, BreaksAtBlanksAndIndents)
{
    EXPECT_EQ(wrapped("  key   one two three four five six seven", 30, 8),
              "  key   one two three four\n        five six seven");
    EXPECT_EQ(wrapped("short", 30, 8), "short");
    EXPECT_EQ(wrapped("  key   one two three four five six seven", 0, 8),
              "  key   one two three four five six seven")
        << "goes to no terminal";
}

TEST(Wrapped, KeepsWideWordsWhole)
{
    EXPECT_EQ(wrapped("a much-too-wide-word-for-this b", 12, 2), "a\nmuch-too-wide-word-for-this\nb")
        << "no room for the indent";
}

TEST(Wrapped, CountsCharactersNotBytes)
{
    EXPECT_EQ(wrapped("25 °C and 30 °C and 35 °C", 25, 2), "25 °C and 30 °C and 35 °C");
}

} // namespace
} // namespace demens::text
