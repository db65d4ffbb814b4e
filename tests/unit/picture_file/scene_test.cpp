// Particles drawn as they are seen from the front.
#include "demens/picture_file/scene.hpp"

#include <gtest/gtest.h>

namespace demens::picture_file {
namespace {

std::array<std::uint8_t, 3> pixel(ColourImage const& image, double right, double down)
{
    auto const column = static_cast<int>(right * image.columns), row = static_cast<int>(down * image.rows);
    return image.pixels[static_cast<std::size_t>(row * image.columns + column)];
}

constexpr std::array<std::uint8_t, 3> white = {255, 255, 255};

TEST(Scene, IsAsHighAsWhatIsThere)
{
    observe::Snapshot snapshot;
    snapshot.x = {0, 2};
    snapshot.y = {0, 0};
    snapshot.z = {0, 0};
    snapshot.radius = {1, 1};
    auto const image = picture_of(snapshot, 400);
    EXPECT_EQ(image.columns, 400);
    EXPECT_NEAR(image.rows, 400 * 2.32 / 4.32, 2)
        << "two spheres side by side, and a margin of 0.04 of the width";
    EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.rows) * 400u);
    EXPECT_NE(pixel(image, 0.25, 0.5), white);
    EXPECT_NE(pixel(image, 0.75, 0.5), white);
    EXPECT_EQ(pixel(image, 0.01, 0.01), white);
    EXPECT_EQ(pixel(image, 0.5, 0.1), white) << "between them";
}

TEST(Scene, HidesWhatIsBehind)
{
    observe::Snapshot snapshot; // seen along y, from the lower side
    snapshot.x = {0, 0, -3, 3};
    snapshot.y = {-1, 1, 0, 0};
    snapshot.z = {0, 0, 0, 0};
    snapshot.radius = {0.5, 0.5, 0.1, 0.1};
    auto const both = picture_of(snapshot);
    std::swap(snapshot.y[0], snapshot.y[1]); // the order in which they are given does not matter
    EXPECT_EQ(picture_of(snapshot).pixels, both.pixels);
    auto const seen = pixel(both, 0.5, 0.5);
    EXPECT_GT(seen[0], 150) << "light as what is in front; the one behind would have 113";
}

TEST(Scene, DrawsWallsAlone)
{
    observe::Snapshot snapshot;
    snapshot.wall_lines = {{0, 0, 0, 1, 0, 1}};
    auto const image = picture_of(snapshot, 100);
    EXPECT_NE(pixel(image, 0.5, 0.5), white);
    EXPECT_EQ(pixel(image, 0.8, 0.8), white);
}

TEST(Scene, ACubeIsSeenAsACube)
{
    // Its corners are balls of its rounding, and one within it is not drawn by itself.
    observe::Snapshot snapshot;
    for (double const x : {-1.0, 1.0})
        for (double const y : {-1.0, 1.0})
            for (double const z : {-1.0, 1.0})
                snapshot.x.push_back(x), snapshot.y.push_back(y), snapshot.z.push_back(z);
    snapshot.radius.assign(8, 0.1), snapshot.hull.assign(8, 1);
    snapshot.x.push_back(0), snapshot.y.push_back(0), snapshot.z.push_back(1.5);
    snapshot.radius.push_back(0.5), snapshot.hull.push_back(observe::Snapshot::within_a_hull);
    auto const image = picture_of(snapshot, 200);
    auto const middle = pixel(image, 0.5, 0.6);
    EXPECT_NE(middle, white);
    EXPECT_EQ(pixel(image, 0.15, 0.6), middle) << "its face is flat, from one edge";
    EXPECT_EQ(pixel(image, 0.85, 0.9), middle) << "... to the other";
    EXPECT_EQ(pixel(image, 0.5, 0.2), white);
}

} // namespace
} // namespace demens::picture_file
