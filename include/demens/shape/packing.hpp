#pragma once

#include "demens/base/random.hpp"
#include "demens/base/vector3.hpp"

#include <vector>

namespace demens::shape {

//! Random places [m] without overlap for spheres of the given diameters [m] in a box that stands on z =
//! lower.z and is as high as a solid fraction of about `solid_fraction` (at most 0.33) needs. The result is
//! in the order of `diameters`. \throws InputError when the box is narrower than the largest sphere.
std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random);

} // namespace demens::shape
