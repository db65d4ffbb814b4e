#pragma once

#include "src/dem/cpu/state.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

//! Adds what the surroundings do to the loads of the particles of this process, which must know their
//! contacts. \param step number of the step whose loads these are; 0: those at the very beginning
void add_surrounding_loads(Params const& params, State& state, std::int64_t step);

//! Work of the surroundings [J].
struct SurroundingWork
{
    double drag = 0; //!< never positive, but for rounding
    double vibration = 0;
};

//! Half the work of the loads of one step: of the path that led to it, and of the one that follows.
struct SurroundingWorks
{
    SurroundingWork before, after;
};
SurroundingWorks work_of_surroundings(Params const& params, State const& state, std::int64_t step);

} // namespace demens::dem
