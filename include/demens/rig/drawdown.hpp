#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! The Draw Down Test of `drawdown-ores` (Moncada et al. 2023).
RigInfo drawdown_rig();

} // namespace demens::rig
