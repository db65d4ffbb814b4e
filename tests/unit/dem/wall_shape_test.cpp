// Nearest points of the wall shapes, and how walls are moved.
#include "demens/dem/wall.hpp"

#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using demens::test::expect_near;

TEST(WallShape, RectangleIsTouchedOnItsFaceAnEdgeOrACorner)
{
    dem::Rectangle const plate{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2, 3};
    expect_near(nearest(plate, {1, -2, 5}), {1, -2, 1});
    expect_near(nearest(plate, {9, -2, 5}), {2, -2, 1});
    expect_near(nearest(plate, {9, -9, 0}), {2, -3, 1});
}

TEST(WallShape, DiscIsTouchedOnItsFaceOrRim)
{
    dem::Disc const disc{{0, 0, 1}, {0, 0, 1}, 2};
    expect_near(nearest(disc, {1, 0.5, 4}), {1, 0.5, 1});
    expect_near(nearest(disc, {3, 4, 4}), {1.2, 1.6, 1});
    expect_near(nearest(disc, {0, 0, -3}), {0, 0, 1});
    expect_near(normal(disc, {0, 0, 1}), {0, 0, -1});
}

TEST(WallShape, CylinderIsTouchedFromInsideOutsideAndAtItsRim)
{
    dem::Cylinder const drum{{1, 2, 3}, {0, 1, 0}, 5, 2};
    expect_near(nearest(drum, {1, 4, 3.5}), {1, 4, 5});
    expect_near(nearest(drum, {7, 4, 3}), {3, 4, 3});
    expect_near(nearest(drum, {7, 9, 3}), {3, 7, 3});
    // On the axis every direction is as good: the point is at the radius.
    EXPECT_NEAR(norm(nearest(drum, {1, 3, 3}) - Vector3{1, 3, 3}), 2, 1e-12);
}

TEST(WallShape, ConeIsTouchedAtARightAngleToItsSide)
{
    // 45 degrees: radius 1 at z = -1, 3 at z = 1.
    dem::Cone const cone{{0, 0, 0}, {0, 0, 1}, 1, 1, 3};
    expect_near(nearest(cone, {2 - 0.5, 0, 0.5}), {2, 0, 0});
    expect_near(nearest(cone, {0, 2.5, -0.5}), {0, 2, 0});
    expect_near(nearest(cone, {4, 0, 1}), {3, 0, 1});
    expect_near(nearest(cone, {0.5, 0, -2}), {1, 0, -1});
    double const half = std::sqrt(0.5);
    expect_near(normal(cone, {1, 0, 0}), {half, 0, -half});
    // Its tip is a point.
    dem::Cone const tip{{0, 0, 0}, {0, 0, 1}, 1, 0, 2};
    expect_near(nearest(tip, {0, 0, -3}), {0, 0, -1});
}

TEST(WallShape, BoxHasItsSixSides)
{
    auto const sides = dem::box_sides({-1, 0, 2}, {3, 1, 4});
    Vector3 const inside{0.5, 0.25, 3.5};
    double const distance[] = {1.5, 2.5, 0.25, 0.75, 1.5, 0.5};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(norm(inside - nearest(sides[k], inside)), distance[k], 1e-12) << k;
        // A side ends where its neighbours begin: the far corner is the corner of the box.
        Vector3 const corner = nearest(sides[k], {99, 99, 99});
        EXPECT_NEAR(k == 0 ? corner.x + 4 : corner.x, 3, 1e-12);
        EXPECT_NEAR(k == 2 ? corner.y + 1 : corner.y, 1, 1e-12);
        EXPECT_NEAR(k == 4 ? corner.z + 2 : corner.z, 4, 1e-12);
    }
}

TEST(Wall, SurfaceMovesWithVelocitySpinAndBelt)
{
    dem::Wall const wall{.shape = dem::Disc{{0, 0, 0}, {0, 0, 1}, 1},
                         .velocity = {1, 0, 0},
                         .spin = {0, 0, 2},
                         .pivot = {0, 1, 0},
                         .belt = {0, 0, 0.5}};
    expect_near(wall.surface_velocity({3, 1, 0}), {1, 6, 0.5});
}

TEST(Wall, ATurnAboutTheOwnAxisDoesNotDisplaceARoundShape)
{
    Vector3 const axis{0.48, 0.6, 0.64}, centre{0.1, -0.2, 0.3};
    double const rate = 7;
    for (dem::WallShape const& shape :
         {dem::WallShape(dem::Disc{centre, axis, 0.5}), dem::WallShape(dem::Cylinder{centre, axis, 1, 0.5}),
          dem::WallShape(dem::Cone{centre, axis, 1, 0.5, 0.2})}) {
        dem::Wall wall{.shape = shape, .spin = rate * axis, .pivot = centre + 0.3 * axis};
        EXPECT_EQ(displacement_speed(wall), 0);
        advance(wall, 0.1);
        EXPECT_EQ(dem::centre(wall.shape), centre);
        // About another axis it is displaced, at most at the speed of its farthest point.
        wall.spin = {rate, 0, 0};
        EXPECT_GT(displacement_speed(wall), 0);
        EXPECT_LE(displacement_speed(wall), rate * (extent(shape) + 0.3) * (1 + 1e-12));
    }
    dem::Wall const plate{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 3, 4}, .spin = {0, 0, 2}};
    EXPECT_NEAR(displacement_speed(plate), 10, 1e-12);
}

TEST(Wall, AdvancingTurnsItAboutItsPivot)
{
    dem::Wall wall{.shape = dem::Rectangle{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1},
                   .velocity = {0, 0, 1},
                   .spin = {0, 0, 0.5 * std::numbers::pi},
                   .pivot = {1, 0, 0}};
    advance(wall, 1);
    auto const& plate = std::get<dem::Rectangle>(wall.shape);
    expect_near(plate.centre, {1, 1, 1});
    expect_near(plate.axis_u, {0, 1, 0});
    expect_near(wall.pivot, {1, 0, 1});
}

} // namespace
