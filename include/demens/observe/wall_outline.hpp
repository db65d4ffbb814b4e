#pragma once

#include "demens/dem/wall.hpp"
#include "demens/observe/snapshot.hpp"

namespace demens::observe {

//! Adds a wall to a snapshot: a rectangle along the axes as it is; of other walls the rims and creases as
//! lines, and the surface as triangles.
void add_outline(Snapshot& snapshot, dem::Wall const& wall);

} // namespace demens::observe
