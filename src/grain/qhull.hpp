#pragma once

#include "demens/base/vector3.hpp"

#include <span>
#include <string>
#include <vector>

namespace demens::grain {

//! What Qhull finds: numbers of the points that are corners, ascending, and a plane n . x = offset a side.
struct QhullResult
{
    struct Plane
    {
        Vector3 normal;
        double offset;
    };
    std::vector<std::size_t> corners;
    std::vector<Plane> planes;
    std::string error; //!< what Qhull said where it failed; else empty
};

QhullResult run_qhull(std::span<Vector3 const> points);

} // namespace demens::grain
