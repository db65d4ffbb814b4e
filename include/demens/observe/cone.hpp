#pragma once

#include "demens/observe/surface.hpp"

#include <vector>

namespace demens::observe {

//! Mean height of a surface over the distance from an upright axis.
struct RadialProfile
{
    std::vector<double> r; //!< middles of rings as wide as the surface's columns [m]
    std::vector<double> z; //!< [m]; 0 where a ring has no particles
    double height() const; //!< its highest ring [m]
    //! The outermost distance at which it is so high, on straight lines between the rings [m]; 0 where it
    //! nowhere is.
    double radius_at(double height) const;
};
//! Each ring's columns without particles count with height 0: the plate. \param radius of the outermost ring
//! [m]
RadialProfile radial_profile(SurfaceMap const& map, double radius);

//! A cone fitted to a heap on z = 0 around the z axis.
struct ConeFit
{
    double angle_deg = 0;    //!< mean of the sectors
    double angle_sd_deg = 0; //!< between sectors
    double radius = 0;       //!< where the mean line meets the plate [m]
    int sectors = 0;         //!< with a line; fewer than 3: there is no cone
};
//! Lines through the heights of columns over their distance from the axis, one a sector, between the
//! distances at which the mean profile is `toe` and 1 - `tip` of its height. Of what is as flat as a layer of
//! grains, less than three columns between these, all of it is slope. \param sectors as many, or as there are
//! six columns for each, but three
ConeFit fit_cone(SurfaceMap const& map, int sectors, double toe, double tip);

} // namespace demens::observe
