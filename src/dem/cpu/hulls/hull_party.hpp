#pragma once

#include "demens/grain/contact/core.hpp"
#include "src/dem/cpu/state.hpp"

namespace demens::dem {

//! One side of a contact of hulls: a hull, or a ball, whose core is a point.
struct HullParty
{
    grain::CoreView core;
    grain::CorePose pose;
    double rounding; //!< [m]
    double ball;     //!< radius of the ball that stands for it in laws: that of the sphere of its volume [m]
};

//! \param point core of balls
inline HullParty party_of(State const& state, std::uint32_t particle, grain::CoreView const& point)
{
    Place const& p = state.particles.place[particle];
    Vector3 const place{p.x, p.y, p.z};
    if (!state.particles.is_hull(particle))
        return {point, {place, {}, 1}, p.radius, p.radius};
    std::uint32_t const body = state.particles.body[particle];
    grain::RoundedHull const& hull = *state.bodies.hull_shape(body).hull;
    double const radius = state.bodies.mass[body].radius;
    return {grain::CoreView(hull.core),
            {place, state.bodies.pose[body].orientation.rotation(), radius},
            radius * hull.rounding,
            radius};
}

} // namespace demens::dem
