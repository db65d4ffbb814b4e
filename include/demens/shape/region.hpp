#pragma once

#include "demens/base/vector3.hpp"

#include <variant>

namespace demens::shape {

//! A box along the axes.
struct BoxRegion
{
    Vector3 lower, upper; //!< [m]
};

//! A cylinder, hollow where its inner radius is not 0.
struct CylinderRegion
{
    Vector3 from, to;            //!< ends of the axis [m]
    double radius, inner_radius; //!< [m]
};

struct BallRegion
{
    Vector3 centre; //!< [m]
    double radius;  //!< [m]
};

//! A part of space in which particles are put or counted.
using Region = std::variant<BoxRegion, CylinderRegion, BallRegion>;

//! Whether a sphere lies in the region with all of it; a point has the radius 0.
bool contains(Region const& region, Vector3 const& centre, double radius = 0);
double volume(Region const& region); //!< [m^3]; 0 or less: there is no such region

//! Box along the axes that holds a region [m].
BoxRegion bounds(Region const& region);
//! Smallest box along the axes that holds two of them.
BoxRegion hull(BoxRegion const& a, BoxRegion const& b);

} // namespace demens::shape
