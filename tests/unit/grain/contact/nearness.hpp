#pragma once

#include "demens/base/vector3.hpp"

#include <gtest/gtest.h>

namespace demens::grain {

inline void expect_near(Vector3 const& found, Vector3 const& expected, double tolerance)
{
    EXPECT_LE(norm(found - expected), tolerance) << found.x << ' ' << found.y << ' ' << found.z << ", not "
                                                 << expected.x << ' ' << expected.y << ' ' << expected.z;
}

} // namespace demens::grain
