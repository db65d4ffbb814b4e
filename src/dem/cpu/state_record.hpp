#pragma once

#include "demens/dem/state_record.hpp"
#include "src/dem/cpu/removal.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

//! Adds all of a state to a record, and what the parameters must have in common with those it goes on with.
void write_state(StateRecord& record, Params const& params, State const& state);
//! A state that goes on with these parameters. \throws InputError where it cannot.
State read_state(StateRecord const& record, Params const& params);
//! \throws InputError where contacts name what is not there; they may name these particles.
void check_contacts(State const& state, ContactNumbers const& numbers);

} // namespace demens::dem
