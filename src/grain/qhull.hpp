#pragma once

#include "demens/base/vector3.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace demens::grain {

//! What Qhull finds: numbers of points, three a triangle, counter-clockwise seen from outside, which close
//! the hull. Triangles of one plane have that plane's normal, also where they have no area of their own.
struct QhullResult
{
    struct Triangle
    {
        std::array<std::size_t, 3> corners;
        Vector3 normal; //!< unit, outwards
    };
    std::vector<Triangle> triangles;
    std::string error; //!< what Qhull said where it failed; else empty
};

QhullResult run_qhull(std::span<Vector3 const> points);

} // namespace demens::grain
