#pragma once

#include "demens/dem/wall_shape.hpp"

namespace demens::observe {

//! The part of a rectangle beside a box: what its sides leave within the box's extent along them. One that
//! lies wholly beside it keeps a strip of no width.
dem::Rectangle cut_to(dem::Rectangle const& rectangle, Vector3 const& lower, Vector3 const& upper);

} // namespace demens::observe
