#pragma once

#include "tests/unit/grain/hulls.hpp"
#include "tests/verification/clump_scene.hpp"

//! What the tests of hulls have in common; bodies, floor and material are those of `clump_scene`.
namespace demens::test {

//! \param rounding of edges, over the hull's own lengths
inline std::shared_ptr<grain::BodyShape const> shape_of(grain::Hull const& hull, double rounding)
{
    return std::make_shared<grain::BodyShape const>(
        grain::body_shape(grain::rounded(hull, rounding, "hull"), "hull"));
}

inline std::shared_ptr<grain::BodyShape const> box(double a, double b, double c, double rounding = 0.04)
{
    return shape_of(grain::box_hull(a, b, c), rounding);
}

//! Half the sides of a box along its axes [m], and how far its contacts are from its centre across them.
inline Vector3 corner_of(grain::BodyShape const& shape)
{
    Vector3 corner;
    for (Vector3 const& v : shape.hull->core.vertices())
        corner = {std::max(corner.x, v.x), std::max(corner.y, v.y), std::max(corner.z, v.z)};
    return radius * corner;
}
inline double rounding_of(grain::BodyShape const& shape)
{
    return radius * shape.hull->rounding;
}

//! The principal axes of a box ascend with its moments: its longest side is along x.
inline Vector3 half_sides(grain::BodyShape const& shape)
{
    double const r = rounding_of(shape);
    return corner_of(shape) + Vector3{r, r, r};
}

//! Overlap of a contact of spheres of this size on a wall of the same material, under a force [m].
inline double hertz_overlap(double force)
{
    double const modulus = stone.youngs_modulus / (2 * (1 - stone.poisson_ratio * stone.poisson_ratio));
    return std::pow(0.75 * force / (modulus * std::sqrt(radius)), 2.0 / 3);
}

} // namespace demens::test
