#pragma once

#include "demens/dem/state_record.hpp"
#include "src/dem/cpu/removal.hpp"

namespace demens::dem {

// Hulls and their contacts to a record and back; they are in it only where there are hulls.

void write_hulls(StateRecord& record, State const& state);
bool has_hulls(StateRecord const& record);
//! The lists of contacts must be there. \throws InputError where an array is missing or does not fit
void read_hulls(StateRecord const& record, State& state);
//! \throws InputError where hulls do not fit with particles and bodies, or contacts, which may name these
//! particles, with both
void check_hulls(State const& state, ContactNumbers const& numbers);

} // namespace demens::dem
