#pragma once

#include "src/rig/custom/setup.hpp"

namespace demens::rig::custom {

//! What can be known about the particles' first places before a run. \throws InputError
void check_places(Setup const& setup);

//! Adds the groups that enter when a stage begins. \throws InputError when there is no room for them now
void enter(World& world, Setup const& setup, std::size_t stage);

} // namespace demens::rig::custom
