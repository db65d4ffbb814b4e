#pragma once

#include "demens/base/macros.hpp"
#include "demens/base/vector3.hpp"

#include <cstdint>

namespace demens::dem {

//! A rigid rectangle, solid from both sides; a plane is a rectangle larger than the domain. It touches a
//! sphere at its point nearest to the centre: on its face, an edge or a corner.
struct Wall
{
    Vector3 centre;         //!< [m]
    Vector3 axis_u, axis_v; //!< orthogonal unit vectors along the sides
    double half_u, half_v;  //!< half lengths of the sides [m]
    std::uint32_t material = 0;
    Vector3 velocity = {}; //!< prescribed translation [m/s]
    bool active = true;    //!< an inactive wall touches nothing

    DEMENS_FUNCTION Vector3 normal() const { return cross(axis_u, axis_v); }

    //! Point of the rectangle nearest to p [m].
    DEMENS_INLINE DEMENS_FUNCTION Vector3 nearest(Vector3 const& p) const
    {
        Vector3 const relative = p - centre;
        double const a = dot(relative, axis_u);
        double const b = dot(relative, axis_v);
        double const u = a < -half_u ? -half_u : a > half_u ? half_u : a;
        double const v = b < -half_v ? -half_v : b > half_v ? half_v : b;
        return centre + u * axis_u + v * axis_v;
    }
};

} // namespace demens::dem
