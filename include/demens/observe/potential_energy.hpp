#pragma once

#include "demens/dem/state_view.hpp"

namespace demens::observe {

//! Potential energy of all particles over their mass [J/kg]: g times the mean height above z = `lowest`,
//! weighted by mass.
double specific_potential_energy(dem::StateView const& particles, double gravity, double lowest);

} // namespace demens::observe
