#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! A rig that is described by its experiment alone: `src/rig/custom/CUSTOM.md`.
RigInfo custom_rig();

} // namespace demens::rig
