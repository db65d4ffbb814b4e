#pragma once

#include "demens/base/vector3.hpp"

namespace demens::contact {

//! Three components, each one number or those of several contacts side by side.
template <class Number>
struct Components
{
    Number x, y, z;
};

//! What a contact does to its bodies; j gets the opposite force.
template <class Number>
struct BodyLoads
{
    Components<Number> force, torque_i, torque_j; //!< [N], about the centres [N m]
};

//! The force acts at the contact point, -arm_i n from i and arm_j n from j; the rolling torque is that on i.
template <class Number>
DEMENS_INLINE DEMENS_FUNCTION BodyLoads<Number> body_loads(Components<Number> const& n, Number const& arm_i,
                                                           Number const& arm_j, Components<Number> const& f,
                                                           Components<Number> const& rolling)
{
    Number const cx = n.y * f.z - n.z * f.y, cy = n.z * f.x - n.x * f.z, cz = n.x * f.y - n.y * f.x; // n x f
    return {f,
            {rolling.x - arm_i * cx, rolling.y - arm_i * cy, rolling.z - arm_i * cz},
            {-(rolling.x + arm_j * cx), -(rolling.y + arm_j * cy), -(rolling.z + arm_j * cz)}};
}

//! Torque about a wall's pivot [N m] of what acts on a sphere, whose centre is `arm` from the pivot.
DEMENS_INLINE DEMENS_FUNCTION Vector3 torque_on_wall(Vector3 const& arm, Vector3 const& force,
                                                     Vector3 const& torque_i)
{
    return -(cross(arm, force) + torque_i);
}

} // namespace demens::contact
