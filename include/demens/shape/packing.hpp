#pragma once

#include "demens/base/random.hpp"
#include "demens/base/vector3.hpp"
#include "demens/shape/region.hpp"

#include <functional>
#include <vector>

namespace demens::shape {

//! Random places [m] without overlap for spheres of the given diameters [m] in a box that stands on z =
//! lower.z and is as high as a solid fraction of about `solid_fraction` (at most 0.33) needs. The result is
//! in the order of `diameters`. \throws InputError when the box is narrower than the largest sphere.
std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random);

struct Sphere
{
    Vector3 centre; //!< [m]
    double radius;  //!< [m]
};

//! Whether a sphere of this centre and radius [m] may be placed, e.g. touches no wall.
using FreeTest = std::function<bool(Vector3 const&, double)>;

//! Random places [m] in a region for spheres of the given diameters [m], without overlap among themselves and
//! with `obstacles`. The result is in the order of `diameters`. \throws InputError when there is no room.
std::vector<Vector3> fill_region(std::vector<double> const& diameters, Region const& region,
                                 std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                 RandomStream& random);
//! About how much of a region [m^3] a sphere of this radius may be placed in.
double free_volume(Region const& region, double radius, FreeTest const& is_free);

} // namespace demens::shape
