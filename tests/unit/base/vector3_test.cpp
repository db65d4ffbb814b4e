#include "demens/base/rotation.hpp"
#include "demens/base/vector3.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using demens::test::expect_near;
using std::numbers::pi;

TEST(Vector3, ProductsAreThoseOfTheAxes)
{
    constexpr Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    static_assert(cross(x, y) == z && cross(y, z) == x && cross(z, x) == y && cross(y, x) == -z);
    static_assert(dot(Vector3{1, 2, 3}, Vector3{4, -5, 6}) == 12);
    static_assert(norm_squared(Vector3{2, 3, 6}) == 49);
    EXPECT_EQ(norm(Vector3{2, 3, 6}), 7);
    static_assert(2 * Vector3{1, 2, 3} - Vector3{1, 1, 1} == Vector3{1, 3, 5});
    EXPECT_EQ((Vector3{2, 4, 8} / 2), (Vector3{1, 2, 4}));
}

TEST(Vector3, AnyNormalIsAUnitVectorAtARightAngle)
{
    for (Vector3 const& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, -1}, Vector3{0.6, 0, 0.8},
                                Vector3{2.0 / 7, 3.0 / 7, 6.0 / 7}}) {
        EXPECT_NEAR(norm(any_normal_to(axis)), 1, 1e-15);
        EXPECT_NEAR(dot(any_normal_to(axis), axis), 0, 1e-16);
    }
}

TEST(Rotation, TurnsCounterClockwiseSeenAgainstTheAxis)
{
    Rotation const quarter = rotation_about({0, 0, 1}, pi / 2);
    expect_near(quarter({1, 0, 0}), {0, 1, 0}, 1e-15);
    expect_near(quarter({0, 1, 5}), {-1, 0, 5}, 1e-15);
    expect_near(quarter.inverse({0, 1, 0}), {1, 0, 0}, 1e-15);
    // A third of a turn about the diagonal of a cube moves each axis to the next.
    double const c = 1 / std::sqrt(3.0);
    Rotation const third = rotation_about({c, c, c}, 2 * pi / 3);
    expect_near(third({1, 0, 0}), {0, 1, 0}, 1e-15);
    expect_near(third({0, 0, 1}), {1, 0, 0}, 1e-15);
}

TEST(Rotation, ProductsAreDoneFromTheRight)
{
    Rotation const about_x = rotation_about({1, 0, 0}, pi / 2), about_z = rotation_about({0, 0, 1}, pi / 2);
    expect_near((about_z * about_x)({0, 1, 0}), {0, 0, 1}, 1e-15);  // y -> z -> z
    expect_near((about_x * about_z)({0, 1, 0}), {-1, 0, 0}, 1e-15); // y -> -x -> -x
}

TEST(Placement, TurnsAndThenShifts)
{
    Placement const place{rotation_about({0, 0, 1}, pi / 2), {1, 2, 3}};
    expect_near(place({1, 0, 0}), {1, 3, 3}, 1e-15);
    expect_near(place.inverse({1, 3, 3}), {1, 0, 0}, 1e-15);
    Placement const about_line = turn_about({1, 0, 9}, {0, 0, 1}, pi); // through (1, 0)
    expect_near(about_line({0, 0, 4}), {2, 0, 4}, 1e-15);
    expect_near(about_line({1, 0, 7}), {1, 0, 7}, 1e-15);
    expect_near((place * about_line)({0, 0, 4}), place({2, 0, 4}), 1e-15);
}

} // namespace
