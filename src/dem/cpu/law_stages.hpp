#pragma once

#include "demens/contact/evaluation/state_layout.hpp"
#include "src/dem/cpu/contact_block.hpp"

namespace demens::dem {

//! Evaluates the laws: forces, torques and the new history of all lanes; with room for the ledger also the
//! energy that each lane has lost since the step before.
void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, contact::StateLayout const& layout,
                   double time_step);

} // namespace demens::dem
