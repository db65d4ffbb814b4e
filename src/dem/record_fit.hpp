#pragma once

#include "demens/dem/state_record.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

//! Adds to a record what the simulation that goes on from it must have in common with this one.
void write_fit(StateRecord& record, Params const& params);
//! \throws InputError where this one has anything else.
void check_fit(StateRecord const& record, Params const& params);

} // namespace demens::dem
