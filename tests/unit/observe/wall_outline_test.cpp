#include "demens/observe/wall_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace demens::observe {
namespace {

Snapshot outline_of(dem::WallShape const& shape)
{
    Snapshot snapshot;
    add_outline(snapshot, {.shape = shape});
    return snapshot;
}

double area(Snapshot const& snapshot)
{
    double sum = 0;
    for (auto const& t : snapshot.wall_triangles) {
        Vector3 const a{t[0], t[1], t[2]}, b{t[3], t[4], t[5]}, c{t[6], t[7], t[8]};
        sum += 0.5 * norm(cross(b - a, c - a));
    }
    return sum;
}

double length(Snapshot const& snapshot)
{
    double sum = 0;
    for (auto const& l : snapshot.wall_lines)
        sum += norm(Vector3{l[3] - l[0], l[4] - l[1], l[5] - l[2]});
    return sum;
}

TEST(WallOutline, ARectangleAlongTheAxesIsABox)
{
    auto const snapshot = outline_of(dem::Rectangle{{1, 2, 3}, {0, -1, 0}, {0, 0, 1}, 0.5, 0.25});
    ASSERT_EQ(snapshot.walls.size(), 1u);
    EXPECT_EQ(snapshot.walls[0], (std::array<double, 6>{1, 1.5, 2.75, 1, 2.5, 3.25}));
    EXPECT_TRUE(snapshot.wall_lines.empty() && snapshot.wall_triangles.empty());
}

TEST(WallOutline, OtherShapesHaveTheirRimsAndSurfaces)
{
    double const half = std::sqrt(0.5), pi = std::numbers::pi;
    auto const tilted = outline_of(dem::Rectangle{{}, {half, half, 0}, {0, 0, 1}, 2, 1});
    EXPECT_TRUE(tilted.walls.empty());
    EXPECT_NEAR(length(tilted), 12, 1e-12);
    EXPECT_NEAR(area(tilted), 8, 1e-12);
    // 64 sides of a circle are 0.04 % short of it, its area 0.16 %.
    auto const drum = outline_of(dem::Cylinder{{}, {0, 1, 0}, 2, 1});
    EXPECT_NEAR(length(drum), 2 * 2 * pi + 4 * 4, 2e-3 * 4 * pi);
    EXPECT_NEAR(area(drum), 2 * pi * 4, 2e-3 * 8 * pi);
    auto const disc = outline_of(dem::Disc{{}, {0, 0, 1}, 3});
    EXPECT_NEAR(length(disc), 6 * pi, 2e-3 * 6 * pi);
    EXPECT_NEAR(area(disc), 9 * pi, 2e-3 * 9 * pi);
    auto const cone = outline_of(dem::Cone{{}, {0, 0, 1}, 2, 3, 0});
    EXPECT_NEAR(area(cone), pi * 3 * 5, 3e-3 * pi * 15);
    EXPECT_NEAR(length(cone), 6 * pi + 4 * 5, 2e-3 * 6 * pi);
}

TEST(WallOutline, AMeshHasItsCreasesButNotTheLinesWithinItsFaces)
{
    auto const mesh = std::make_shared<shape::TriangleMesh>(shape::box_triangles({0, 0, 0}, {1, 2, 3}));
    auto const snapshot = outline_of(dem::Mesh{mesh, {{}, {10, 0, 0}}});
    EXPECT_EQ(snapshot.wall_lines.size(), 12u);
    EXPECT_NEAR(length(snapshot), 4 * (1 + 2 + 3), 1e-12);
    EXPECT_NEAR(area(snapshot), 2 * (2 + 3 + 6), 1e-12);
    for (auto const& l : snapshot.wall_lines)
        EXPECT_GE(l[0], 10);
}

} // namespace
} // namespace demens::observe
