#pragma once

#include "demens/base/vector3.hpp"

#include <gtest/gtest.h>

namespace demens::test {

//! Each component is as expected, up to the tolerance.
inline void expect_near(Vector3 const& a, Vector3 const& b, double tolerance = 1e-12)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

} // namespace demens::test
