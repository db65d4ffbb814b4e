#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/surroundings.hpp"

#include <cmath>
#include <numbers>

namespace demens::dem {

//! See `Surroundings::drag_per_speed`.
DEMENS_FUNCTION inline double drag_per_speed_in(Surroundings const& around, double diameter, double speed)
{
    constexpr double pi = std::numbers::pi, newton_from = 1000;
    double const stokes = 3 * pi * around.viscosity * diameter, inertia = around.density * diameter * speed;
    if (inertia >= newton_from * around.viscosity)
        return 0.44 * pi / 8 * inertia * diameter;
    return stokes * (1 + 0.15 * std::pow(inertia / around.viscosity, 0.687));
}

//! See `Surroundings::acceleration`.
DEMENS_FUNCTION inline Vector3 acceleration_in(Surroundings const& around, double time)
{
    constexpr double pi = std::numbers::pi;
    return std::sin(2 * pi * around.frequency * time) * around.vibration;
}

//! What surroundings do to a particle.
struct SurroundingForces
{
    Vector3 drag, shaking; //!< [N]
};

//! On a particle whose velocity is that of the middle of the step before: the drag is half a step behind,
//! which changes it by a part of the time step over the time in which it brakes.
DEMENS_FUNCTION inline SurroundingForces forces_on(Surroundings const& around, Place const& p,
                                                   Motion const& m, Vector3 const& acceleration)
{
    Vector3 const velocity{m.vx, m.vy, m.vz};
    bool const resists = around.viscosity > 0 || around.density > 0;
    double const resistance = resists ? drag_per_speed_in(around, 2 * p.radius, norm(velocity)) : 0.0;
    return {-resistance * velocity, m.mass * acceleration};
}

} // namespace demens::dem
