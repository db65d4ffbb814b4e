#include "demens/observe/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace demens::observe {

SurfaceProfile surface_profile(dem::Particles const& particles, double from_x, double to_x, int points,
                               double empty, std::function<bool(dem::Place const&)> const& select)
{
    SurfaceProfile profile{{}, std::vector<double>(static_cast<std::size_t>(points), empty), empty};
    double const step = (to_x - from_x) / points;
    for (int k = 0; k < points; ++k)
        profile.x.push_back(from_x + (k + 0.5) * step);
    for (dem::Place const& p : particles.place) {
        if (!select(p))
            continue;
        int const first = std::max(0, static_cast<int>(std::ceil((p.x - p.radius - from_x) / step - 0.5)));
        int const last =
            std::min(points - 1, static_cast<int>(std::floor((p.x + p.radius - from_x) / step - 0.5)));
        for (int k = first; k <= last; ++k) {
            double const dx = profile.x[static_cast<std::size_t>(k)] - p.x;
            double const top = p.z + std::sqrt(std::max(0.0, p.radius * p.radius - dx * dx));
            auto& z = profile.z[static_cast<std::size_t>(k)];
            z = std::max(z, top);
        }
    }
    return profile;
}

double mean_surface_height(dem::Particles const& particles, double width)
{
    std::map<std::pair<long, long>, double> tops;
    for (dem::Place const& p : particles.place) {
        auto const first = [&](double x) {
            return static_cast<long>(std::ceil((x - p.radius) / width - 0.5));
        };
        auto const last = [&](double x) {
            return static_cast<long>(std::floor((x + p.radius) / width - 0.5));
        };
        for (long i = first(p.x); i <= last(p.x); ++i)
            for (long j = first(p.y); j <= last(p.y); ++j) {
                double const dx = (i + 0.5) * width - p.x, dy = (j + 0.5) * width - p.y;
                double const rest = p.radius * p.radius - dx * dx - dy * dy;
                if (rest < 0)
                    continue;
                double const top = p.z + std::sqrt(rest);
                auto const [column, is_new] = tops.try_emplace({i, j}, top);
                if (!is_new)
                    column->second = std::max(column->second, top);
            }
    }
    double sum = 0;
    for (auto const& [column, top] : tops)
        sum += top;
    return sum / static_cast<double>(tops.size());
}

double Line::angle_deg() const
{
    return std::atan(slope) * 180 / std::numbers::pi;
}

Line fit_line(std::vector<double> const& x, std::vector<double> const& y)
{
    Line line;
    line.points = static_cast<int>(x.size());
    if (x.empty())
        return line;
    double const n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
        mean_x += x[k] / n, mean_y += y[k] / n;
    double sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sxx += (x[k] - mean_x) * (x[k] - mean_x);
        sxy += (x[k] - mean_x) * (y[k] - mean_y);
    }
    line.slope = sxx > 0 ? sxy / sxx : 0;
    line.intercept = mean_y - line.slope * mean_x;
    return line;
}

Line fit_line(SurfaceProfile const& profile, double from_x, double to_x)
{
    std::vector<double> x, z;
    for (std::size_t k = 0; k < profile.x.size(); ++k)
        if (profile.x[k] >= from_x && profile.x[k] <= to_x && profile.z[k] > profile.empty) {
            x.push_back(profile.x[k]);
            z.push_back(profile.z[k]);
        }
    return fit_line(x, z);
}

} // namespace demens::observe
