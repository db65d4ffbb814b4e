#pragma once

#include "demens/dem/wall_shape.hpp"
#include "demens/rig/rig.hpp"
#include "src/rig/kinds.hpp"

#include <vector>

namespace demens::rig::custom {

//! A shape that `[[experiment.wall]]` may have, read as the surfaces that it consists of. \throws InputError
using WallShapeKind = ReadKind<std::vector<dem::WallShape>, Files const&>;
std::vector<WallShapeKind> const& wall_shapes();

//! Whether it is a plane, which is large without end until it is fitted to the domain.
bool is_plane(dem::WallShape const& shape);

} // namespace demens::rig::custom
