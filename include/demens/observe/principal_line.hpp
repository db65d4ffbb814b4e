#pragma once

#include <array>
#include <vector>

namespace demens::observe {

using Point = std::array<double, 2>;

//! The line through points with the least squared distances across it (principal component regression), so
//! that the result does not depend on how the points are turned.
struct PrincipalLine
{
    double angle_deg = 0; //!< of the line, in (-90, 90]
    double r2 = 0;        //!< 1 - squared distances from the line over squared distances from the mean point
    int points = 0;       //!< how many points it rests on; with fewer than 3 the line means nothing
};
PrincipalLine fit_principal_line(std::vector<Point> const& points);

} // namespace demens::observe
