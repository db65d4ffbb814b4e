#pragma once

#include "demens/dem/simulation.hpp"

#include <functional>
#include <string>

namespace demens::rig {

//! \param moment says when it is, in words \throws RunFailure for a simulation that is no longer one of what
//! was asked for: a place that is no number, a particle outside, an overlap or an error of the ledger beyond
//! the limit
void check_health(dem::Simulation& simulation, bool has_rigid_bodies,
                  std::function<std::string()> const& moment);

} // namespace demens::rig
