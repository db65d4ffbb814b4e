// Boxes around regions.
#include "demens/shape/region.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;

TEST(Region, ItsBoundsTouchItOnAllSides)
{
    auto const ball = shape::bounds(shape::BallRegion{{1, 2, 3}, 0.5});
    EXPECT_EQ(ball.lower, (Vector3{0.5, 1.5, 2.5}));
    EXPECT_EQ(ball.upper, (Vector3{1.5, 2.5, 3.5}));
    auto const upright = shape::bounds(shape::CylinderRegion{{1, 2, 5}, {1, 2, 3}, 0.5, 0});
    EXPECT_EQ(upright.lower, (Vector3{0.5, 1.5, 3}));
    EXPECT_EQ(upright.upper, (Vector3{1.5, 2.5, 5}));
}

TEST(Region, AHullHoldsBothBoxes)
{
    auto const hull = shape::hull({{0, 0, 0}, {1, 5, 1}}, {{-1, 2, 3}, {0.5, 4, 7}});
    EXPECT_EQ(hull.lower, (Vector3{-1, 0, 0}));
    EXPECT_EQ(hull.upper, (Vector3{1, 5, 7}));
}

} // namespace
