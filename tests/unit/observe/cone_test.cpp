#include "demens/observe/cone.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::observe {
namespace {

//! A cone of columns of 1 mm with a rounded tip and a flat toe around it.
SurfaceMap cone(double angle_deg, double height, double tip, double toe)
{
    double const slope = std::tan(angle_deg * std::numbers::pi / 180);
    SurfaceMap map{1e-3, {}};
    for (long i = -80; i < 80; ++i)
        for (long j = -80; j < 80; ++j) {
            double const z = height - slope * std::hypot(i + 0.5, j + 0.5) * 1e-3;
            if (z > -toe)
                map.columns.push_back({i, j, std::max(std::min(z, tip), 1e-4)});
        }
    return map;
}

TEST(Cone, AngleAndRadiusAreThoseOfTheSlopeWithoutTipAndToe)
{
    for (double const angle : {12.0, 25.0, 40.0}) {
        double const height = 0.02, foot = height / std::tan(angle * std::numbers::pi / 180);
        auto const fit = fit_cone(cone(angle, height, 0.9 * height, 2e-3), 12, 0.2, 0.25);
        EXPECT_EQ(fit.sectors, 12);
        EXPECT_NEAR(fit.angle_deg, angle, 0.05);
        EXPECT_LT(fit.angle_sd_deg, 0.05);
        EXPECT_NEAR(fit.radius, foot, 0.005 * foot);
    }
}

TEST(Cone, ASlopeThatDiffersAroundTheAxisShowsInTheScatter)
{
    auto map = cone(25, 0.02, 0.02, 0);
    for (auto& column : map.columns)
        if (column.i > 0) // the other half leans less
            column.top = std::max(0.0, 0.02 - 0.3 * std::hypot(column.i + 0.5, column.j + 0.5) * 1e-3);
    auto const fit = fit_cone(map, 12, 0.2, 0.2);
    EXPECT_GT(fit.angle_sd_deg, 3);
}

TEST(Cone, ASmallHeapHasFewerSectors)
{
    // Some 40 columns: of twelve sectors most would have fewer than three to fit a line through.
    auto const fit = fit_cone(cone(30, 2.1e-3, 2.1e-3, 0), 12, 0.2, 0.2);
    EXPECT_GE(fit.sectors, 3);
    EXPECT_LE(fit.sectors, 8);
    EXPECT_NEAR(fit.angle_deg, 30, 2);
}

TEST(Cone, NothingIsNoCone)
{
    EXPECT_EQ(fit_cone({1e-3, {}}, 12, 0.2, 0.2).sectors, 0);
    EXPECT_LT(fit_cone({1e-3, {{0, 0, 1e-3}}}, 12, 0.2, 0.2).sectors, 3);
}

TEST(Cone, RingsCountThePlateBesideTheHeap)
{
    // One column of four that touch the axis.
    auto const profile = radial_profile({1e-3, {{0, 0, 8e-3}}}, 2e-3);
    ASSERT_EQ(profile.r.size(), 2u);
    EXPECT_DOUBLE_EQ(profile.r[1], 1.5e-3);
    EXPECT_DOUBLE_EQ(profile.z[0], 2e-3);
    EXPECT_DOUBLE_EQ(profile.z[1], 0);
    EXPECT_DOUBLE_EQ(profile.height(), 2e-3);
    EXPECT_DOUBLE_EQ(profile.radius_at(1e-3), 1e-3);
}

} // namespace
} // namespace demens::observe
