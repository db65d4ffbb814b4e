#pragma once

#include "src/rig/custom/setup.hpp"

namespace demens::rig::custom {

//! Switches walls and their motions as a stage begins. \throws InputError when a wall appears where particles
//! are
void begin_walls(Bench& bench, Setup const& setup, std::size_t stage);

} // namespace demens::rig::custom
