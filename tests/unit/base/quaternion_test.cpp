// Quaternions turn as rotations do.
#include "demens/base/quaternion.hpp"

#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using demens::test::expect_near;

Vector3 const axis = Vector3{1, -2, 0.5} / norm(Vector3{1, -2, 0.5});
Vector3 const v{0.3, 0.7, -1.1};

TEST(Quaternion, TurnsAsRodriguesSays)
{
    for (double const angle : {0.0, 1e-9, 5e-5, 0.3, 1.5, 3.1}) {
        Rotation const rotation = rotation_about(axis, angle);
        Quaternion const q = quaternion_about(angle * axis);
        expect_near(q(v), rotation(v), 1e-15);
        expect_near(q.rotation()(v), rotation(v), 1e-15);
        expect_near(q.inverse(q(v)), v, 1e-15);
    }
    expect_near(quaternion_about({0, 0, 0.5 * std::numbers::pi})({1, 0, 0}), {0, 1, 0}, 1e-15);
}

TEST(Quaternion, ProductTurnsByTheRightOneFirst)
{
    Quaternion const a = quaternion_about({0.4, 0, 0}), b = quaternion_about({0, -0.9, 0.2});
    expect_near((a * b)(v), a(b(v)), 1e-15);
}

// Half turns about each axis and between them take each of the four cases.
TEST(Quaternion, OfARotationIsFoundAgain)
{
    for (Vector3 const& about : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}, axis})
        for (double const angle : {0.0, 0.7, 2.5, std::numbers::pi}) {
            Rotation const rotation = rotation_about(about, angle);
            Quaternion const q = quaternion_of(rotation);
            EXPECT_GE(q.w, 0);
            expect_near(q(v), rotation(v), 4e-15);
        }
    EXPECT_EQ(quaternion_of(Rotation{}), Quaternion{});
}

} // namespace
