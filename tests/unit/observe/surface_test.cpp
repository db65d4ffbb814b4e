#include "demens/observe/layers.hpp"
#include "demens/observe/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;

//! Small spheres along z = |slope x|, falling away from the middle when slope < 0.
std::vector<dem::Place> roof(double slope)
{
    std::vector<dem::Place> places;
    for (int k = -500; k <= 500; ++k) {
        double const x = 1e-3 * k;
        places.push_back({x, 0, slope * std::abs(x), 1e-3});
        places.push_back({x, 0, slope * std::abs(x) - 0.05, 1e-3}); // below, hidden
    }
    return places;
}

TEST(Surface, ProfileFollowsTheHighestSpheres)
{
    auto const profile =
        observe::surface_profile(roof(-0.5), -0.4, 0.4, 200, [](auto const&) { return true; });
    ASSERT_EQ(profile.x.size(), 200u);
    for (std::size_t k = 0; k < profile.x.size(); ++k)
        EXPECT_NEAR(profile.z[k], -0.5 * std::abs(profile.x[k]) + 1e-3 * std::sqrt(1.25), 3e-4);
}

TEST(Surface, LineHasTheSlopeOfTheSide)
{
    auto const profile =
        observe::surface_profile(roof(-0.5), -0.4, 0.4, 200, [](auto const&) { return true; });
    EXPECT_NEAR(observe::fit_line(profile.x, profile.z, 0.05, 0.35).slope, -0.5, 2e-3);
    EXPECT_NEAR(observe::fit_line(profile.x, profile.z, -0.35, -0.05).slope, 0.5, 2e-3);
    EXPECT_NEAR(observe::fit_line(profile.x, profile.z, 0.05, 0.35).angle_deg(), -26.565, 0.1);
}

TEST(Surface, GapsAreLeftOut)
{
    std::vector<dem::Place> const one = {{0, 0, 1, 0.1}};
    auto const profile = observe::surface_profile(one, -1, 1, 100, [](auto const&) { return true; });
    EXPECT_EQ(observe::fit_line(profile.x, profile.z, 0.5, 1).points, 0);
    EXPECT_EQ(observe::fit_line(profile.x, profile.z, -1, 1).points, 10);
}

TEST(Surface, MapOfOneSphereIsTwoThirdsOfItsRadiusHighOnTheMean)
{
    EXPECT_TRUE(std::isnan(observe::surface_map({}, 0.1).mean_height()));
    std::vector<dem::Place> const places = {{0, 0, 5, 1}, {0.1, 0, 3, 0.5}}; // the second one hides below
    auto const map = observe::surface_map(places, 0.005);
    EXPECT_NEAR(map.mean_height(), 5 + 2.0 / 3, 2e-4);
    // Over x the mean of sqrt(1 - x^2 - y^2) over |y| < sqrt(1 - x^2): pi/4 sqrt(1 - x^2).
    auto const profile = map.along_x();
    ASSERT_EQ(profile.x.size(), 400u);
    EXPECT_NEAR(profile.x[300], 0.5025, 1e-12);
    EXPECT_NEAR(profile.z[300], 5 + M_PI / 4 * std::sqrt(1 - 0.5025 * 0.5025), 2e-3);
}

TEST(Layers, OfASphereAreThoseOfItsCaps)
{
    // A sphere of radius 1 at z = 1 in two layers of 0.5 from z = 0: caps of heights 0.5 and 1.
    std::vector<dem::Place> const one = {{0, 0, 1, 1}};
    auto const volumes = observe::volume_in_layers(one, 0, 1, 2);
    EXPECT_NEAR(volumes[0], M_PI / 3 * 0.25 * 2.5, 1e-12);
    EXPECT_NEAR(volumes[0] + volumes[1], M_PI / 3 * 2, 1e-12);
}

TEST(Surface, LeastSquaresLine)
{
    // Anscombe's first data set: y = 3.000 + 0.500 x.
    auto const line = observe::fit_line({10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5},
                                        {8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68});
    EXPECT_NEAR(line.slope, 0.50009, 1e-5);
    EXPECT_NEAR(line.intercept, 3.00009, 1e-5);
}

} // namespace
