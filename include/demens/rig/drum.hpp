#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! A rotating drum: energies of `drum-am-powders`, end views of `drum-wood-powders`.
RigInfo drum_rig();

} // namespace demens::rig
