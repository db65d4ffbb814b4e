#pragma once

#include "demens/base/vector3.hpp"
#include "demens/dem/wall_shape.hpp"

namespace demens::dem {

//! From the shape's nearest point to p; where p lies on the shape, a short way along its normal.
template <class Shape>
DEMENS_INLINE DEMENS_FUNCTION Vector3 offset_from(Shape const& shape, Vector3 const& p, double radius)
{
    Vector3 const offset = p - nearest(shape, p);
    return norm_squared(offset) > 0 ? offset : 1e-9 * radius * normal(shape, p);
}

//! Cosine of the angle within which the normal of a contact may turn in a step.
constexpr double like_normals = 0.7;
//! Whether it may have turned from one offset to the other.
DEMENS_FUNCTION inline bool is_like(Vector3 const& one, Vector3 const& other)
{
    double const product = dot(one, other);
    return product > 0 &&
           product * product > like_normals * like_normals * norm_squared(one) * norm_squared(other);
}

} // namespace demens::dem
