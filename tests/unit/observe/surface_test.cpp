#include "demens/observe/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;

//! Small spheres along z = |slope x|, falling away from the middle when slope < 0.
dem::Particles roof(double slope)
{
    dem::Particles particles;
    for (int k = -500; k <= 500; ++k) {
        double const x = 1e-3 * k;
        particles.place.push_back({x, 0, slope * std::abs(x), 1e-3});
        particles.place.push_back({x, 0, slope * std::abs(x) - 0.05, 1e-3}); // below, hidden
    }
    return particles;
}

TEST(Surface, ProfileFollowsTheHighestSpheres)
{
    auto const profile =
        observe::surface_profile(roof(-0.5), -0.4, 0.4, 200, -9, [](auto const&) { return true; });
    ASSERT_EQ(profile.x.size(), 200u);
    for (std::size_t k = 0; k < profile.x.size(); ++k)
        EXPECT_NEAR(profile.z[k], -0.5 * std::abs(profile.x[k]) + 1e-3 * std::sqrt(1.25), 3e-4);
}

TEST(Surface, LineHasTheSlopeOfTheSide)
{
    auto const profile =
        observe::surface_profile(roof(-0.5), -0.4, 0.4, 200, -9, [](auto const&) { return true; });
    EXPECT_NEAR(observe::fit_line(profile, 0.05, 0.35).slope, -0.5, 2e-3);
    EXPECT_NEAR(observe::fit_line(profile, -0.35, -0.05).slope, 0.5, 2e-3);
    EXPECT_NEAR(observe::fit_line(profile, 0.05, 0.35).angle_deg(), -26.565, 0.1);
}

TEST(Surface, GapsAreLeftOut)
{
    dem::Particles particles;
    particles.place.push_back({0, 0, 1, 0.1});
    auto const profile =
        observe::surface_profile(particles, -1, 1, 100, -9, [](auto const&) { return true; });
    EXPECT_EQ(observe::fit_line(profile, 0.5, 1).points, 0);
    EXPECT_EQ(observe::fit_line(profile, -1, 1).points, 10);
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
