#pragma once

#include <cstdint>

namespace demens::rig {

//! Memory that this process may use: of the machine, or of the control group that it is in [B].
double memory_limit();

//! What so many particles need at least, contacts included, measured with beds of 500,000 [B].
double memory_needed(double particles);

//! \throws InputError where so many particles, shared by so many ranks, do not fit into the memory of each
//! [B], or have more numbers than there are
void check_memory(double particles, int ranks, double available);

} // namespace demens::rig
