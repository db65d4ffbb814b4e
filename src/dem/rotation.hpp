#pragma once

#include "demens/base/quaternion.hpp"

namespace demens::dem {

//! How a rigid body turns: its moments of inertia are those about its principal axes.
struct RigidTurn
{
    Quaternion orientation;   //!< from the body's axes to those of space
    Vector3 angular_momentum; //!< in the axes of space [kg m^2/s]
};

//! Angular velocity in the axes of space [rad/s]. \param inertia principal moments [kg m^2]
DEMENS_FUNCTION inline Vector3 spin_of(Rotation const& axes, Vector3 const& angular_momentum,
                                       Vector3 const& inertia)
{
    Vector3 const l = axes.inverse(angular_momentum);
    return axes({l.x / inertia.x, l.y / inertia.y, l.z / inertia.z});
}
//! Energy of a turn [J].
DEMENS_FUNCTION inline double rotational_energy(Rotation const& axes, Vector3 const& angular_momentum,
                                                Vector3 const& inertia)
{
    return 0.5 * dot(angular_momentum, spin_of(axes, angular_momentum, inertia));
}

namespace detail {

//! Turns a body for a time about one of its axes, which moves the orientation `q` (not of unit length) and
//! the angular momentum seen from the body. The tangent of half the angle is a polynomial: still an exact
//! turn, and the same bits on every machine.
template <double Quaternion::*part, double Vector3::*about, double Vector3::*next, double Vector3::*last>
DEMENS_FUNCTION inline void turn_about_axis(Quaternion& q, Vector3& seen, Vector3 const& inertia, double time)
{
    double const half = 0.5 * time * (seen.*about) / (inertia.*about);
    double const tangent = half * (1 + half * half * (1.0 / 3));
    double const scale = 1 / (1 + tangent * tangent);
    double const c = (1 - tangent * tangent) * scale, s = 2 * tangent * scale;
    double const u = seen.*next, v = seen.*last;
    seen.*next = c * u + s * v;
    seen.*last = c * v - s * u;
    Quaternion turn{1, 0, 0, 0};
    turn.*part = tangent;
    q = q * turn;
}

} // namespace detail

//! The orientation after a time without torque: Euler's equations in the body's axes, split into exact turns
//! about one axis after the other and back (Dullweber, Leimkuhler and McLachlan 1997). Of second order,
//! reversible, and without drift in energy; the angular momentum in space stays as it is.
DEMENS_FUNCTION inline Quaternion freely_turned(RigidTurn const& body, Vector3 const& inertia, double time)
{
    using V = Vector3;
    using Q = Quaternion;
    Quaternion q = body.orientation;
    Vector3 seen = q.rotation().inverse(body.angular_momentum);
    detail::turn_about_axis<&Q::x, &V::x, &V::y, &V::z>(q, seen, inertia, 0.5 * time);
    detail::turn_about_axis<&Q::y, &V::y, &V::z, &V::x>(q, seen, inertia, 0.5 * time);
    detail::turn_about_axis<&Q::z, &V::z, &V::x, &V::y>(q, seen, inertia, time);
    detail::turn_about_axis<&Q::y, &V::y, &V::z, &V::x>(q, seen, inertia, 0.5 * time);
    detail::turn_about_axis<&Q::x, &V::x, &V::y, &V::z>(q, seen, inertia, 0.5 * time);
    return q.normalized();
}

} // namespace demens::dem
