#pragma once

#include "demens/base/vector3.hpp"

namespace demens::contact {

//! What a sphere touches.
enum class Partner
{
    sphere,
    wall
};

//! Two bodies that touch, or are within reach of each other, as read from their records.
struct Meeting
{
    Vector3 apart;             //!< from j (wall: its nearest point) to i [m]
    double radius_i, radius_j; //!< wall: both the radius of i [m]
    double mass_i, mass_j;     //!< wall: mass_j is `wall_mass` [kg]
    Vector3 velocity;          //!< of i minus that of j (wall: of its surface at the nearest point) [m/s]
    Vector3 spin_i, spin_j;    //!< [rad/s]
};

//! Mass of a wall: beyond any other [kg].
constexpr double wall_mass = 1e300;

//! How the surface of a rigid wall moves.
struct WallSurface
{
    Vector3 velocity; //!< of the pivot, and of a belt over the wall [m/s]
    Vector3 spin;     //!< [rad/s]
    Vector3 pivot;    //!< [m]

    //! Velocity of the surface at the point nearest to a sphere's centre, `apart` from it [m/s].
    DEMENS_INLINE DEMENS_FUNCTION Vector3 velocity_at(Vector3 const& centre, Vector3 const& apart) const
    {
        return velocity + cross(spin, centre - apart - pivot);
    }
};

//! The part of a meeting that one sphere brings.
struct Sphere
{
    Vector3 centre;   //!< [m]
    double radius;    //!< [m]
    Vector3 velocity; //!< [m/s]
    double mass;      //!< [kg]
    Vector3 spin;     //!< [rad/s]
};

//! Of spheres i and j, `apart` from each other [m].
DEMENS_INLINE DEMENS_FUNCTION Meeting meeting(Sphere const& i, Sphere const& j, Vector3 const& apart)
{
    return {apart, i.radius, j.radius, i.mass, j.mass, i.velocity - j.velocity, i.spin, j.spin};
}

//! Of sphere i and a wall, whose nearest point is `apart` from its centre [m].
DEMENS_INLINE DEMENS_FUNCTION Meeting meeting(Sphere const& i, WallSurface const& wall, Vector3 const& apart)
{
    return {apart,  i.radius, i.radius, i.mass, wall_mass, i.velocity - wall.velocity_at(i.centre, apart),
            i.spin, wall.spin};
}

} // namespace demens::contact
