#pragma once

#include "demens/dem/particles.hpp"

#include <functional>
#include <vector>

namespace demens::observe {

//! Upper edge of the particles seen from the front (along y): heights over equally spaced positions.
struct SurfaceProfile
{
    std::vector<double> x; //!< [m]
    std::vector<double> z; //!< top of the highest sphere over x [m]; `empty` where there is none
    double empty;          //!< [m]
};

//! Profile of the selected particles between two positions.
SurfaceProfile surface_profile(dem::Particles const& particles, double from_x, double to_x, int points,
                               double empty, std::function<bool(dem::Place const&)> const& select);

//! Mean height of the highest points of spheres over the middles of square columns [m], columns without any
//! left out; NaN without particles. \param width of a column [m]
double mean_surface_height(dem::Particles const& particles, double width);

//! A straight line z = intercept + slope x.
struct Line
{
    double slope = 0, intercept = 0;
    int points = 0; //!< how many points it rests on; with fewer than 3 the line means nothing
    double angle_deg() const;
};

//! Least-squares line through the profile between two positions, gaps left out.
Line fit_line(SurfaceProfile const& profile, double from_x, double to_x);
//! Least-squares line through y over x.
Line fit_line(std::vector<double> const& x, std::vector<double> const& y);

} // namespace demens::observe
