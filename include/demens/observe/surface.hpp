#pragma once

#include "demens/dem/particles.hpp"
#include "demens/observe/hull_outline.hpp"

#include <functional>
#include <span>
#include <vector>

namespace demens::observe {

//! Upper edge of the particles seen from the front (along y): heights over equally spaced positions.
struct SurfaceProfile
{
    std::vector<double> x; //!< [m]
    std::vector<double> z; //!< top of the highest sphere or hull over x [m]; NaN where there is none
};

//! Profile of the selected particles between two positions. Hulls are selected by the ball that holds them.
SurfaceProfile surface_profile(std::span<dem::Place const> places, double from_x, double to_x, int points,
                               std::function<bool(dem::Place const&)> const& select,
                               std::span<HullOutline const> hulls = {});

//! Heights of the highest points of spheres and hulls over the middles of square columns, those without any
//! left out.
struct SurfaceMap
{
    struct Column
    {
        long i, j;  //!< the middle is at (i + 1/2, j + 1/2) widths
        double top; //!< [m]
    };
    double width;                //!< of a column [m]
    std::vector<Column> columns; //!< in the order of i, then j

    double mean_height() const; //!< [m]; NaN without columns
    //! Mean over y of the heights over each x.
    SurfaceProfile along_x() const;
};
SurfaceMap surface_map(std::span<dem::Place const> places, double width,
                       std::span<HullOutline const> hulls = {});

//! A straight line z = intercept + slope x.
struct Line
{
    double slope = 0, intercept = 0;
    int points = 0; //!< how many points it rests on; with fewer than 3 the line means nothing
    double angle_deg() const;
};

//! Least-squares line through y over x.
Line fit_line(std::vector<double> const& x, std::vector<double> const& y);
//! ... through the points between two positions, gaps (NaN) left out.
Line fit_line(std::vector<double> const& x, std::vector<double> const& y, double from_x, double to_x);

} // namespace demens::observe
