#include "ensemble/input/nearest.hpp"

#include <gtest/gtest.h>

namespace demens::ensemble::input {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps)
{
    EXPECT_EQ(edit_distance("friction", "friction"), 0u);
    EXPECT_EQ(edit_distance("friction", "fiction"), 1u);
    EXPECT_EQ(edit_distance("friction", "friktion"), 1u);
    EXPECT_EQ(edit_distance("friction", "firction"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(Nearest, FindsTheMisspeltWordOnly)
{
    std::vector<std::string> const keys = {"density", "youngs_modulus", "sd"};
    EXPECT_EQ(nearest("desnity", keys), "density");
    EXPECT_EQ(nearest("young_modulus", keys), "youngs_modulus");
    EXPECT_EQ(nearest("sdd", keys), "sd");
    EXPECT_EQ(nearest("colour", keys), "");
    EXPECT_EQ(suggestion("friction", {"static_friction", "restitution", "friction_limit", "frictionless"}),
              "did you mean static_friction, friction_limit?");
    EXPECT_EQ(suggestion("colour", keys), "known: density, youngs_modulus, sd");
}

} // namespace
} // namespace demens::ensemble::input
