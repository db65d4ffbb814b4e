#include "demens/observe/surface.hpp"

#include "demens/base/not_a_number.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace demens::observe {

SurfaceProfile surface_profile(std::span<dem::Place const> places, double from_x, double to_x, int points,
                               std::function<bool(dem::Place const&)> const& select,
                               std::span<HullOutline const> hulls)
{
    SurfaceProfile profile{{}, std::vector<double>(static_cast<std::size_t>(points), not_a_number)};
    double const step = (to_x - from_x) / points;
    for (int k = 0; k < points; ++k)
        profile.x.push_back(from_x + (k + 0.5) * step);
    //! \param top_at of (x)
    auto const raise = [&](double from, double to, auto const& top_at) {
        int const first = std::max(0, static_cast<int>(std::ceil((from - from_x) / step - 0.5)));
        int const last = std::min(points - 1, static_cast<int>(std::floor((to - from_x) / step - 0.5)));
        for (int k = first; k <= last; ++k) {
            double const top = top_at(profile.x[static_cast<std::size_t>(k)]);
            auto& z = profile.z[static_cast<std::size_t>(k)];
            z = std::isnan(z) ? top : std::fmax(z, top);
        }
    };
    for (dem::Place const& p : places)
        if (select(p))
            raise(p.x - p.radius, p.x + p.radius, [&](double x) {
                double const dx = x - p.x;
                return p.z + std::sqrt(std::max(0.0, p.radius * p.radius - dx * dx));
            });
    for (HullOutline const& hull : hulls)
        if (select(hull.place())) {
            auto const [left, right] = hull.across();
            raise(left, right, [&](double x) { return hull.top(x).value_or(not_a_number); });
        }
    return profile;
}

SurfaceMap surface_map(std::span<dem::Place const> places, double width, std::span<HullOutline const> hulls)
{
    std::map<std::pair<long, long>, double> tops;
    //! Over the columns within reach of a place. \param top_at of (x, y), none where it is not
    auto const raise = [&](dem::Place const& p, auto const& top_at) {
        auto const first = [&](double x) {
            return static_cast<long>(std::ceil((x - p.radius) / width - 0.5));
        };
        auto const last = [&](double x) {
            return static_cast<long>(std::floor((x + p.radius) / width - 0.5));
        };
        for (long i = first(p.x); i <= last(p.x); ++i)
            for (long j = first(p.y); j <= last(p.y); ++j) {
                std::optional<double> const top = top_at((i + 0.5) * width, (j + 0.5) * width);
                if (!top)
                    continue;
                auto const [column, is_new] = tops.try_emplace({i, j}, *top);
                if (!is_new)
                    column->second = std::max(column->second, *top);
            }
    };
    for (dem::Place const& p : places)
        raise(p, [&](double x, double y) {
            double const dx = x - p.x, dy = y - p.y, rest = p.radius * p.radius - dx * dx - dy * dy;
            return rest < 0 ? std::nullopt : std::optional(p.z + std::sqrt(rest));
        });
    for (HullOutline const& hull : hulls)
        raise(hull.place(), [&](double x, double y) { return hull.top(x, y); });
    SurfaceMap map{width, {}};
    for (auto const& [column, top] : tops)
        map.columns.push_back({column.first, column.second, top});
    return map;
}

double SurfaceMap::mean_height() const
{
    double sum = 0;
    for (auto const& column : columns)
        sum += column.top;
    return sum / static_cast<double>(columns.size());
}

SurfaceProfile SurfaceMap::along_x() const
{
    SurfaceProfile profile;
    for (std::size_t first = 0, end = 0; first < columns.size(); first = end) {
        double sum = 0;
        for (end = first; end < columns.size() && columns[end].i == columns[first].i; ++end)
            sum += columns[end].top;
        profile.x.push_back((static_cast<double>(columns[first].i) + 0.5) * width);
        profile.z.push_back(sum / static_cast<double>(end - first));
    }
    return profile;
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

Line fit_line(std::vector<double> const& x, std::vector<double> const& y, double from_x, double to_x)
{
    std::vector<double> inner_x, inner_y;
    for (std::size_t k = 0; k < x.size(); ++k)
        if (x[k] >= from_x && x[k] <= to_x && !std::isnan(y[k])) {
            inner_x.push_back(x[k]);
            inner_y.push_back(y[k]);
        }
    return fit_line(inner_x, inner_y);
}

} // namespace demens::observe
