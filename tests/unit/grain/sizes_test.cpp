// Sizes of grains whose sizes are known.
#include "demens/grain/sizes.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::grain;

Sizes sizes_of(Hull const& hull)
{
    return sizes(corner_balls({hull, 0}));
}

TEST(Sizes, OfASphereAreItsDiameter)
{
    Sizes const found = sizes(Clump{{{1, 2, 3}, 0.5}});
    EXPECT_EQ(found.largest_feret, 1);
    EXPECT_EQ(found.smallest_feret, 1);
    EXPECT_EQ(found.square_sieve, 1);
    EXPECT_EQ(found.round_sieve, 1);
}

TEST(Sizes, OfARodOfSpheresAreItsLengthAndItsThickness)
{
    Sizes const found = sizes(Clump{{{0, 0, 0}, 0.5}, {{0.6, 0.6, 0}, 0.4}, {{1.2, 1.2, 0}, 0.3}});
    EXPECT_NEAR(found.largest_feret, 0.8 + 1.2 * std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(found.smallest_feret, 1, 1e-5);
    EXPECT_NEAR(found.square_sieve, 1, 1e-5);
    EXPECT_NEAR(found.round_sieve, 1, 1e-5);
}

TEST(Sizes, OfACube)
{
    Sizes const found = sizes_of(cube_hull(1));
    EXPECT_NEAR(found.largest_feret, std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(found.smallest_feret, 1, 1e-5);
    EXPECT_NEAR(found.square_sieve, 1, 1e-5);
    EXPECT_NEAR(found.round_sieve, std::sqrt(2.0), 2e-5);
}

// A plate passes a square hole across its diagonal: its side is then (width + thickness) / sqrt(2).
TEST(Sizes, OfAPlateAreSmallerAcrossTheDiagonal)
{
    Sizes const found = sizes_of(box_hull(0.2, 3, 5));
    EXPECT_NEAR(found.smallest_feret, 0.2, 1e-5);
    EXPECT_NEAR(found.square_sieve, 3.2 / std::sqrt(2.0), 3e-5);
    EXPECT_NEAR(found.round_sieve, std::hypot(0.2, 3), 3e-5);
}

// The smallest width of a regular tetrahedron is that between opposite edges, edge / sqrt(2); the square
// around its projection along the line between them, whose diagonals are the edges, has that side too.
TEST(Sizes, OfATetrahedron)
{
    Sizes const found = sizes_of(tetrahedron_hull(1));
    EXPECT_NEAR(found.largest_feret, 1, 1e-14);
    EXPECT_NEAR(found.smallest_feret, 1 / std::sqrt(2.0), 1e-5);
    EXPECT_NEAR(found.square_sieve, 1 / std::sqrt(2.0), 1e-5);
}

TEST(Sizes, GrowWithTheRounding)
{
    RoundedHull const cube{cube_hull(1), 0.25};
    Sizes const found = sizes(corner_balls(cube));
    EXPECT_NEAR(found.square_sieve, 1.5, 1e-5);
    EXPECT_NEAR(found.largest_feret, std::sqrt(3.0) + 0.5, 1e-14);
    MassProperties const properties = mass_properties(cube);
    EXPECT_EQ(size_by(SizeMeasure::equivalent, properties, found), properties.equivalent_diameter());
    EXPECT_EQ(size_by(SizeMeasure::round_sieve, properties, found), found.round_sieve);
}

} // namespace
