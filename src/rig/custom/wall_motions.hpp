#pragma once

#include "demens/dem/wall_motion.hpp"
#include "src/rig/kinds.hpp"

#include <vector>

namespace demens::rig::custom {

//! A law that `[[experiment.wall.motion]]` may follow. \throws InputError
using WallMotionKind = ReadKind<decltype(dem::WallMotion::law)>;
std::vector<WallMotionKind> const& wall_motions();

} // namespace demens::rig::custom
