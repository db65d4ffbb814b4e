#pragma once

#include "demens/base/quaternion.hpp"
#include "demens/base/random.hpp"
#include "demens/base/vector3.hpp"
#include "demens/shape/region.hpp"

#include <functional>
#include <span>
#include <vector>

namespace demens::shape {

struct Sphere
{
    Vector3 centre; //!< [m]
    double radius;  //!< [m]
};

//! Spheres that are placed together, as one body.
struct SphereGroup
{
    std::span<Sphere const> spheres; //!< about the body's centre, over `size`
    double size;                     //!< radius of the sphere of the same volume [m]

    //! One sphere of the body's own size; a larger one holds a body that is turned.
    bool is_sphere() const { return spheres.size() == 1 && spheres.front().radius == 1; }
    double reach() const;   //!< of the furthest point from the centre [m]
    double largest() const; //!< diameter of its largest sphere [m]
};

//! Where a group is put; a single sphere is not turned.
struct GroupPlace
{
    Vector3 centre; //!< [m]
    Quaternion orientation = {};
};

//! Random places [m] without overlap for spheres of the given diameters [m] in a box that stands on z =
//! lower.z and is as high as a solid fraction of about `solid_fraction` (at most 0.33) needs. The result is
//! in the order of `diameters`. \throws InputError when the box is narrower than the largest sphere.
std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random);
//! The same for groups, each turned at random.
std::vector<GroupPlace> place_loosely(std::vector<SphereGroup> const& groups, Vector3 const& lower,
                                      double width_x, double width_y, double solid_fraction,
                                      RandomStream& random);

//! Whether a sphere of this centre and radius [m] may be placed, e.g. touches no wall.
using FreeTest = std::function<bool(Vector3 const&, double)>;

//! Random places [m] in a region for spheres of the given diameters [m], without overlap among themselves and
//! with `obstacles`. The result is in the order of `diameters`. \throws InputError when there is no room.
std::vector<Vector3> fill_region(std::vector<double> const& diameters, Region const& region,
                                 std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                 RandomStream& random);
//! The same for groups, each turned at random: the spheres of each are in the region, free, and overlap with
//! none of another one.
std::vector<GroupPlace> place_in_region(std::vector<SphereGroup> const& groups, Region const& region,
                                        std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                        RandomStream& random);
//! Any orientation, all alike (Shoemake 1992).
Quaternion random_orientation(RandomStream& random);
//! About how much of a region [m^3] a sphere of this radius may be placed in.
double free_volume(Region const& region, double radius, FreeTest const& is_free);

} // namespace demens::shape
