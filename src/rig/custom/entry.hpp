#pragma once

#include "src/rig/custom/setup.hpp"

namespace demens::rig::custom {

//! What can be known about the particles' first places before a run. \throws InputError
void check_places(Setup const& setup);

//! Adds the groups that enter when a stage begins. \throws InputError when there is no room for them now
void enter(Bench& bench, Setup const& setup, std::size_t stage);

//! Adds the batches of the inlet of a stage that are due. \throws InputError when there is no room for them
//! now
void pour(Bench& bench, Setup const& setup, std::size_t stage);

//! \throws InputError when a wall that appears reaches deeper into a particle than may overlap at first
void check_room_for_wall(Bench& bench, Setup const& setup, WallPlan const& plan, dem::Wall const& part,
                         std::string const& stage);

} // namespace demens::rig::custom
