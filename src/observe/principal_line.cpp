#include "demens/observe/principal_line.hpp"

#include <cmath>
#include <numbers>

namespace demens::observe {

PrincipalLine fit_principal_line(std::vector<Point> const& points)
{
    PrincipalLine line;
    line.points = static_cast<int>(points.size());
    if (points.empty())
        return line;
    double const n = static_cast<double>(points.size());
    double mean_x = 0, mean_z = 0;
    for (auto const& [x, z] : points)
        mean_x += x / n, mean_z += z / n;
    double sxx = 0, szz = 0, sxz = 0;
    for (auto const& [x, z] : points) {
        sxx += (x - mean_x) * (x - mean_x);
        szz += (z - mean_z) * (z - mean_z);
        sxz += (x - mean_x) * (z - mean_z);
    }
    // The squared distances from the line are the smaller eigenvalue of the scatter matrix.
    double const total = sxx + szz, difference = std::hypot(sxx - szz, 2 * sxz);
    line.r2 = total > 0 ? 0.5 * (total + difference) / total : 0;
    line.angle_deg = 0.5 * std::atan2(2 * sxz, sxx - szz) * 180 / std::numbers::pi;
    return line;
}

} // namespace demens::observe
