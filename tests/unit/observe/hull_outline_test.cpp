// Rounded hulls as they are seen.
#include "demens/base/random.hpp"
#include "demens/grain/contact/core_gap.hpp"
#include "demens/observe/end_view.hpp"
#include "demens/observe/surface.hpp"
#include "demens/shape/packing.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;

dem::HullPlace hull_at(grain::Hull const& hull, double rounding, Vector3 const& position = {},
                       Quaternion const& orientation = {})
{
    auto const shape = std::make_shared<grain::BodyShape const>(
        grain::body_shape(grain::rounded(hull, rounding, "hull"), "hull"));
    return {dem::ParticleId{0}, position, orientation, 2e-3, shape};
}

//! Half a side of a cube, and its rounding [m].
double half_side(dem::HullPlace const& cube)
{
    return cube.radius * cube.shape->hull->core.vertices()[0].x;
}

TEST(HullOutline, CubeIsSeenAsASquareWithRoundCorners)
{
    auto const cube = hull_at(grain::cube_hull(1), 0.1, {1e-3, 0, 5e-3});
    double const r = cube.rounding(), half = std::abs(half_side(cube)) + r;
    observe::HullOutline const seen(cube);
    EXPECT_NEAR(*seen.top(1e-3), 5e-3 + half, 1e-15);
    EXPECT_NEAR(*seen.top(1e-3 + 0.99 * (half - r)), 5e-3 + half, 1e-15);
    EXPECT_NEAR(*seen.top(1e-3 + half - 0.5 * r), 5e-3 + half - r + std::sqrt(0.75) * r, 1e-15);
    EXPECT_FALSE(seen.top(1e-3 + 1.01 * half));
    EXPECT_NEAR(seen.across(5e-3)->first, 1e-3 - half, 1e-15);
    EXPECT_NEAR(seen.across(5e-3)->second, 1e-3 + half, 1e-15);
    EXPECT_NEAR(seen.across().second, 1e-3 + half, 1e-15);
    EXPECT_NEAR(seen.upwards().first, 5e-3 - half, 1e-15);
    // On its edge.
    auto const turned =
        hull_at(grain::cube_hull(1), 0.1, {}, quaternion_about({0, 0.25 * std::numbers::pi, 0}));
    observe::HullOutline const tip(turned);
    double const diagonal = std::sqrt(2.0) * (half - r);
    EXPECT_NEAR(*tip.top(0), diagonal + r, 1e-15);
    EXPECT_NEAR(*tip.top(0.5 * diagonal), 0.5 * diagonal + std::sqrt(2.0) * r, 1e-15);
    EXPECT_NEAR(*observe::HullOutline(turned).top(0.5 * diagonal, 0), *tip.top(0.5 * diagonal), 1e-15);
}

TEST(HullOutline, TopIsWhereTheRoundingEnds)
{
    // Of any hull that stands any way the highest point over a place is as far from its core as its rounding.
    RandomStream random(3);
    auto const point = grain::point_hull();
    std::vector const hulls = {hull_at(grain::tetrahedron_hull(1), 0.05),
                               hull_at(grain::box_hull(1.5, 1, 0.7), 0.05)};
    for (int k = 0; k < 200; ++k) {
        auto place = hulls[static_cast<std::size_t>(k % 2)];
        place.orientation = shape::random_orientation(random);
        observe::HullOutline const seen(place);
        double const x = random.uniform(-2e-3, 2e-3), y = random.uniform(-2e-3, 2e-3);
        auto const top = seen.top(x, y);
        auto const distance = [&](double z) {
            grain::PairMemory memory;
            grain::CorePair const pair(grain::CoreView(place.shape->hull->core),
                                       {{}, place.orientation.rotation(), place.radius},
                                       grain::CoreView(point), {{x, y, z}});
            return grain::core_gap(pair, 1, memory).gap;
        };
        if (top) {
            EXPECT_NEAR(distance(*top), place.rounding(), 1e-9 * place.radius);
            EXPECT_GT(distance(*top + 1e-5), place.rounding());
            EXPECT_LE(*top, *seen.top(x) + 1e-12) << "no higher than as seen from the front";
        } else {
            for (int n = -20; n <= 20; ++n)
                EXPECT_GT(distance(2e-4 * n), place.rounding());
        }
    }
}

TEST(HullOutline, ViewsAndSurfacesTakeIt)
{
    auto const cube = hull_at(grain::cube_hull(1), 0.1, {1e-3, 0, -2e-3}, quaternion_about({0, 0.3, 0}));
    std::vector<observe::HullOutline> const hulls = {observe::HullOutline(cube)};
    double const r = cube.rounding(), side = 2 * (std::abs(half_side(cube)) + r), drum = 8e-3;
    double const area = side * side - (4 - std::numbers::pi) * r * r;
    observe::EndView view(drum, 1000);
    view.draw({}, hulls);
    EXPECT_NEAR(view.covered_fraction(), area / (std::numbers::pi * drum * drum), 1e-5);
    auto const profile = observe::surface_profile(
        {}, -1e-2, 1e-2, 100, [](auto const& p) { return p.z < 0; }, hulls);
    for (std::size_t k = 0; k < profile.x.size(); ++k) {
        auto const top = hulls[0].top(profile.x[k]);
        EXPECT_EQ(top.has_value(), std::isfinite(profile.z[k]));
        if (top) {
            EXPECT_EQ(*top, profile.z[k]);
        }
    }
    auto const none = observe::surface_profile(
        {}, -1e-2, 1e-2, 100, [](auto const& p) { return p.z > 0; }, hulls);
    EXPECT_TRUE(std::isnan(none.z[55]));
    // As seen from above the turn about y makes it wider along x, and its top a slope.
    auto const map = observe::surface_map({}, 1e-4, hulls);
    double const seen = static_cast<double>(map.columns.size()) * 1e-8;
    EXPECT_NEAR(seen, side * (std::cos(0.3) + std::sin(0.3)) * side, 0.1 * seen);
    EXPECT_LT(map.mean_height(), -2e-3 + 0.5 * side * (std::cos(0.3) + std::sin(0.3)));
}

} // namespace
