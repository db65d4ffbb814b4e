#pragma once

#include "demens/base/vector3.hpp"

namespace demens::dem {

//! What acts on every particle beside gravity and contacts: a gas or liquid at rest, and a rig that shakes,
//! seen from the rig. By default nothing.
struct Surroundings
{
    double viscosity = 0;   //!< of the gas or liquid [Pa s]
    double density = 0;     //!< of it [kg/m^3]; it bears nothing up
    Vector3 vibration = {}; //!< amplitude of the acceleration, which goes as sin(2 pi f t) [m/s^2]
    double frequency = 0;   //!< of the vibration [1/s]

    bool resists() const { return viscosity > 0 || density > 0; }
    bool shakes() const { return norm_squared(vibration) > 0; }
    bool is_any() const { return resists() || shakes(); }

    //! Drag over speed of a sphere at a speed, kg/s: Stokes's 3 pi eta d times 1 + 0.15 Re^0.687 (Schiller
    //! and Naumann 1933); from Re = rho d v/eta = 1000 on Newton's coefficient of 0.44.
    double drag_per_speed(double diameter, double speed) const;
    //! Acceleration of the rig's frame that particles feel [m/s^2].
    Vector3 acceleration(double time) const;

    friend bool operator==(Surroundings const&, Surroundings const&) = default;
};

} // namespace demens::dem
