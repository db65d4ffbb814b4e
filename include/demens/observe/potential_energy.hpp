#pragma once

#include "demens/dem/state_view.hpp"

namespace demens::observe {

//! Potential energy of all particles over their mass [J/kg]: g times the mean height, against gravity
//! [m/s^2], above the lowest point, weighted by mass.
double specific_potential_energy(dem::StateView const& particles, Vector3 const& gravity,
                                 Vector3 const& lowest);

} // namespace demens::observe
