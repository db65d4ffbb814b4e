#pragma once

#include "demens/dem/energy.hpp"
#include "demens/dem/state_view.hpp"
#include "src/dem/cpu/state.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

// Energies of the particles and contacts of this process as they are.

CatchUp catch_up(Params const& params, State const& state);
double kinetic_energy(Params const& params, State const& state);   //!< translation and rotation [J]
double potential_energy(Params const& params, State const& state); //!< in gravity, from the origin [J]
//! What contacts hold; histories must have room for the ledger.
contact::StoredEnergy stored_energy(Params const& params, State const& state);
//! The entries of a ledger that tell what there is now.
EnergyLedger present_energy(Params const& params, State const& state);

} // namespace demens::dem
