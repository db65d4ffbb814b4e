#pragma once

#include "demens/contact/evaluation/meeting.hpp"
#include "demens/dem/ids.hpp"
#include "demens/dem/wall_shape.hpp"

namespace demens::dem {

//! A rigid surface with prescribed motion.
struct Wall
{
    WallShape shape;
    MaterialId material = {};
    Vector3 velocity = {}; //!< of the pivot [m/s]
    Vector3 spin = {};     //!< [rad/s]
    Vector3 pivot = {};    //!< point of the wall about which it turns and torques are counted [m]
    Vector3 belt = {};     //!< velocity of a surface that runs over the wall, e.g. a conveyor [m/s]
    bool active = true;    //!< an inactive wall touches nothing

    //! Velocity of the surface at p [m/s].
    DEMENS_INLINE DEMENS_FUNCTION Vector3 surface_velocity(Vector3 const& p) const
    {
        return velocity + belt + cross(spin, p - pivot);
    }
    //! What a contact reads of it.
    contact::WallSurface surface() const { return {velocity + belt, spin, pivot}; }
};

//! How a wall moves from now on, steadily.
struct WallVelocity
{
    Vector3 velocity = {}; //!< of the pivot [m/s]
    Vector3 spin = {};     //!< [rad/s]
    Vector3 belt = {};     //!< of a surface that runs over the wall [m/s]
};

//! What the particles do to a wall.
struct WallLoad
{
    Vector3 force;  //!< [N]
    Vector3 torque; //!< about the wall's pivot [N m]
};

//! Bound on how fast any part of the shape changes its place [m/s]; a drum that turns about its axis stays.
double displacement_speed(Wall const& wall);
//! Moves the wall by its velocity and spin for some time [s].
void advance(Wall& wall, double duration);

} // namespace demens::dem
