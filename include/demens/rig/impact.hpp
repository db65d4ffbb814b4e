#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! One sphere hits a plane: the smallest experiment, done in milliseconds.
RigInfo impact_rig();

} // namespace demens::rig
