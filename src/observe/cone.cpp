#include "demens/observe/cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::observe {
namespace {

struct Polar
{
    double r, azimuth; //!< [m], in [0, 2 pi)
};

Polar middle_of(SurfaceMap const& map, SurfaceMap::Column const& column)
{
    double const x = (static_cast<double>(column.i) + 0.5) * map.width,
                 y = (static_cast<double>(column.j) + 0.5) * map.width;
    double const azimuth = std::atan2(y, x);
    return {std::hypot(x, y), azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth};
}

} // namespace

double RadialProfile::height() const
{
    return z.empty() ? 0 : *std::max_element(z.begin(), z.end());
}

double RadialProfile::radius_at(double height) const
{
    for (std::size_t k = z.size(); k-- > 1;)
        if (z[k - 1] >= height && z[k] < height)
            return r[k - 1] + (z[k - 1] - height) / (z[k - 1] - z[k]) * (r[k] - r[k - 1]);
    return 0;
}

RadialProfile radial_profile(SurfaceMap const& map, double radius)
{
    auto const rings = static_cast<std::size_t>(std::ceil(radius / map.width));
    RadialProfile profile{{}, std::vector<double>(rings, 0.0)};
    for (std::size_t k = 0; k < rings; ++k)
        profile.r.push_back((static_cast<double>(k) + 0.5) * map.width);
    for (auto const& column : map.columns)
        if (auto const ring = static_cast<std::size_t>(middle_of(map, column).r / map.width); ring < rings)
            profile.z[ring] += column.top;
    // How many columns a ring has, those without particles too.
    std::vector<double> counts(rings, 0.0);
    long const reach = static_cast<long>(rings) + 1;
    for (long i = -reach; i < reach; ++i)
        for (long j = -reach; j < reach; ++j)
            if (auto const ring = static_cast<std::size_t>(middle_of(map, {i, j, 0}).r / map.width);
                ring < rings)
                ++counts[ring];
    for (std::size_t k = 0; k < rings; ++k)
        profile.z[k] /= counts[k];
    return profile;
}

ConeFit fit_cone(SurfaceMap const& map, int sectors, double toe, double tip)
{
    double furthest = 0;
    for (auto const& column : map.columns)
        furthest = std::max(furthest, middle_of(map, column).r);
    auto const profile = radial_profile(map, furthest + 2 * map.width);
    double const height = profile.height();
    double const outer = profile.radius_at(toe * height), top = profile.radius_at((1 - tip) * height);
    double const inner = outer - top < 3 * map.width ? 0 : top;
    // A line wants some columns: a small heap has fewer sectors.
    constexpr long per_sector = 6;
    auto const is_fitted = [&](SurfaceMap::Column const& column) {
        double const distance = middle_of(map, column).r;
        return distance >= inner && distance <= outer;
    };
    long const fitted = std::count_if(map.columns.begin(), map.columns.end(), is_fitted);
    sectors = static_cast<int>(std::min<long>(sectors, std::max(3L, fitted / per_sector)));
    std::vector<std::vector<double>> r(static_cast<std::size_t>(sectors)), z(r.size());
    for (auto const& column : map.columns) {
        auto const [distance, azimuth] = middle_of(map, column);
        auto const sector =
            std::min(r.size() - 1, static_cast<std::size_t>(azimuth / (2 * std::numbers::pi) * sectors));
        if (is_fitted(column)) {
            r[sector].push_back(distance);
            z[sector].push_back(column.top);
        }
    }
    ConeFit fit;
    double sum = 0, squares = 0, radii = 0;
    for (std::size_t sector = 0; sector < r.size(); ++sector) {
        Line const line = fit_line(r[sector], z[sector]);
        if (line.points < 3)
            continue;
        double const angle = -line.angle_deg();
        sum += angle;
        squares += angle * angle;
        radii += line.slope < 0 ? std::min(-line.intercept / line.slope, furthest) : outer;
        ++fit.sectors;
    }
    double const n = fit.sectors;
    if (fit.sectors < 3)
        return fit;
    fit.angle_deg = sum / n;
    fit.angle_sd_deg = std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1));
    fit.radius = radii / n;
    return fit;
}

} // namespace demens::observe
