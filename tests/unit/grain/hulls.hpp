#pragma once

#include "demens/grain/hull.hpp"

#include <cmath>

namespace demens::grain {

inline Hull box_hull(double a, double b, double c)
{
    std::vector<Vector3> points;
    for (double const x : {-0.5, 0.5})
        for (double const y : {-0.5, 0.5})
            for (double const z : {-0.5, 0.5})
                points.push_back({a * x, b * y, c * z});
    return convex_hull(points, "box");
}

inline Hull cube_hull(double side)
{
    return box_hull(side, side, side);
}

//! Regular, its centre at 0.
inline Hull tetrahedron_hull(double edge)
{
    double const a = edge / std::sqrt(8.0);
    return convex_hull(std::vector<Vector3>{{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}}, "tetrahedron");
}

//! Points spread over a sphere along a spiral, all of them corners.
inline std::vector<Vector3> spiral(int count, double radius)
{
    std::vector<Vector3> points;
    for (int k = 0; k < count; ++k) {
        double const z = (2.0 * k + 1) / count - 1, angle = 2.399963229728653 * k, r = std::sqrt(1 - z * z);
        points.push_back({radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z});
    }
    return points;
}

} // namespace demens::grain
