#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! One sphere hits a plane: the smallest experiment, done in milliseconds.
RigInfo impact_rig();
//! The Draw Down Test of `drawdown-ores` (Moncada et al. 2023).
RigInfo drawdown_rig();
//! A rotating drum: energies of `drum-am-powders`, end views of `drum-wood-powders`.
RigInfo drum_rig();
//! A heap poured by a lifted cylinder or a funnel: the static angle of repose.
RigInfo heap_rig();
//! A rig that is described by its experiment alone: `src/rig/custom/CUSTOM.md`.
RigInfo custom_rig();
//! Another program, given parameters in files: `src/rig/command/COMMAND.md`.
RigInfo command_rig();

} // namespace demens::rig
