#pragma once

#include "src/rig/custom/walls.hpp"

namespace demens::rig::custom {

//! Pairs of walls that go on into each other, where they stand at first, and that the engine does not join:
//! of two materials, or one of them a mesh. A warning for each.
std::vector<std::string> seam_warnings(std::vector<WallPlan> const& walls);

} // namespace demens::rig::custom
