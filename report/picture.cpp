#include "report/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::report {

using nlohmann::json;

namespace {

constexpr std::size_t largest_picture = 20000; //!< particles; those behind are left out
constexpr double resolution = 8192;            //!< quanta over the larger side of a picture
constexpr std::size_t longest_series = 500;    //!< points a line

struct Range
{
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    void include(double value, double margin = 0)
    {
        lower = std::min(lower, value - margin);
        upper = std::max(upper, value + margin);
    }
    double width() const { return std::max(0.0, upper - lower); }
};

//! Extent of particles and walls along one axis (0, 1, 2).
Range extent_of(rig::Snapshot const& snapshot, std::vector<double> const& coordinates, std::size_t axis)
{
    Range range;
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        if (std::isfinite(coordinates[i])) range.include(coordinates[i], snapshot.radius[i]);
    for (auto const& wall : snapshot.walls) {
        range.include(wall[axis]);
        range.include(wall[axis + 3]);
    }
    return range;
}

} // namespace

json picture_of(rig::Snapshot const& snapshot)
{
    Range const along_x = extent_of(snapshot, snapshot.x, 0);
    Range const along_y = extent_of(snapshot, snapshot.y, 1);
    Range const vertical = extent_of(snapshot, snapshot.z, 2);
    bool const seen_along_y = along_x.width() >= along_y.width();
    Range const& horizontal = seen_along_y ? along_x : along_y;
    Range const& into = seen_along_y ? along_y : along_x;
    auto const& across = seen_along_y ? snapshot.x : snapshot.y;
    auto const& depth = seen_along_y ? snapshot.y : snapshot.x;

    double const quantum = std::max({horizontal.width(), vertical.width(), 1e-12}) / resolution;
    auto quanta = [&](double length) { return std::lround(length / quantum); };

    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < across.size(); ++i)
        if (std::isfinite(across[i]) && std::isfinite(depth[i]) && std::isfinite(snapshot.z[i])) order.push_back(i);
    std::ranges::stable_sort(order, [&](auto a, auto b) { return depth[a] > depth[b]; });
    std::size_t const hidden = order.size() > largest_picture ? order.size() - largest_picture : 0;
    order.erase(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(hidden));

    json h = json::array(), v = json::array(), r = json::array(), d = json::array(), speed = json::array();
    for (auto i : order) {
        h.push_back(quanta(across[i] - horizontal.lower));
        v.push_back(quanta(snapshot.z[i] - vertical.lower));
        r.push_back(quanta(snapshot.radius[i]));
        d.push_back(into.width() > 0 ? std::lround(100 * (depth[i] - into.lower) / into.width()) : 0);
        double const squared = snapshot.vx[i] * snapshot.vx[i] + snapshot.vy[i] * snapshot.vy[i] +
                               snapshot.vz[i] * snapshot.vz[i];
        speed.push_back(std::round(1000 * std::sqrt(squared)) / 1000);
    }

    json walls = json::array();
    for (auto const& wall : snapshot.walls) {
        std::size_t const axis = seen_along_y ? 0 : 1;
        walls.push_back({quanta(wall[axis] - horizontal.lower), quanta(wall[2] - vertical.lower),
                         quanta(wall[axis + 3] - horizontal.lower), quanta(wall[5] - vertical.lower)});
    }
    return {{"name", snapshot.name},
            {"time", snapshot.time},
            {"axes", {seen_along_y ? "x" : "y", "z"}},
            {"origin", {horizontal.lower, vertical.lower}},
            {"size", {quanta(horizontal.width()), quanta(vertical.width())}},
            {"quantum", quantum},
            {"hidden", hidden},
            {"particles", {{"h", h}, {"v", v}, {"r", r}, {"depth", d}, {"speed", speed}}},
            {"walls", walls}};
}

json series_of(rig::Series const& series)
{
    json columns = json::array();
    for (std::size_t c = 0; c < series.columns.size(); ++c) {
        auto const& column = series.columns[c];
        std::size_t const stride = std::max<std::size_t>(1, column.size() / longest_series);
        json values = json::array();
        for (std::size_t i = 0; i < column.size(); i += stride) values.push_back(column[i]);
        columns.push_back({{"name", series.names.at(c)}, {"units", series.units.at(c)}, {"values", values}});
    }
    return columns;
}

} // namespace demens::report
