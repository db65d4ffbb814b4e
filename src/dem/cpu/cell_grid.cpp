#include "src/dem/cpu/cell_grid.hpp"

#include "demens/base/error.hpp"

#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace demens::dem {
namespace {

//! The radius up to which particles share the cells such that the fewest pairs must be tested: cells that fit
//! few large particles hold very many small ones.
double choose_regular_radius(std::vector<Place> const& places, double reach, Vector3 const& extent)
{
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    for (Place const& p : places) {
        smallest = std::min(smallest, p.radius);
        largest = std::max(largest, p.radius);
    }
    if (largest < 2 * smallest)
        return largest;
    auto const cube = [](double x) { return x * x * x; };
    double const cell = 2 * largest + reach;
    double const volume = std::max(extent.x, cell) * std::max(extent.y, cell) * std::max(extent.z, cell);
    double const all = static_cast<double>(places.size());
    double best = largest, least = 0.5 * all * all * 27 * cube(cell) / volume;
    for (double below = 0.7 * largest; below > 0.7 * smallest; below *= 0.7) {
        double regular = 0, regular_count = 0, around_large = 0;
        for (Place const& p : places)
            if (p.radius <= below) {
                regular = std::max(regular, p.radius);
                regular_count += 1;
            }
        double const cells = 2 * regular + reach;
        for (Place const& p : places)
            if (p.radius > below)
                around_large += cube(2 * (p.radius + regular + reach) + cells);
        double const large_count = all - regular_count;
        double const tests = 0.5 * regular_count * regular_count * 27 * cube(cells) / volume +
                             regular_count * around_large / volume + 0.5 * large_count * large_count;
        if (regular_count > 0 && tests < 0.8 * least) {
            least = tests;
            best = regular;
        }
    }
    return best;
}

} // namespace

void check_periods(Periods const& periods, double largest_radius, double reach)
{
    double const shortest = 2 * (2 * largest_radius + reach);
    for (auto const& [name, period] : {std::pair{"x", periods.x}, std::pair{"y", periods.y}})
        if (period.on() && period.length() < shortest)
            throw InputError(
                fmt::format("the period of {} m along {} is too short: it must be at least {} m, twice the "
                            "largest diameter and the skin",
                            period.length(), name, shortest));
}

CellGrid::CellGrid(std::vector<Place> const& places, double reach, Periods const& periods) : periods_(periods)
{
    std::array<double, 3> low{}, high{};
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Place const& p = places[i];
        std::array<double, 3> const at{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = i == 0 ? at[axis] : std::min(low[axis], at[axis]);
            high[axis] = i == 0 ? at[axis] : std::max(high[axis], at[axis]);
        }
        largest = std::max(largest, p.radius);
    }
    check_periods(periods, largest, reach);
    if (!periods.any())
        std::stable_sort(axes_.begin(), axes_.end(),
                         [&](std::size_t a, std::size_t b) { return high[a] - low[a] < high[b] - low[b]; });
    lower_ = {low[axes_[0]], low[axes_[1]], low[axes_[2]]};
    Vector3 extent = Vector3{high[axes_[0]], high[axes_[1]], high[axes_[2]]} - lower_;
    for (auto const& [period, from, size] :
         {std::tuple{&periods.x, &lower_.x, &extent.x}, std::tuple{&periods.y, &lower_.y, &extent.y}})
        if (period->on())
            *from = period->lower, *size = period->length();
    regular_radius_ = choose_regular_radius(places, reach, extent);
    double cell = std::max(2 * regular_radius_ + reach, 1e-12);
    // A period holds whole cells.
    auto const cells_along = [&](double length, bool periodic) {
        return std::max(1.0, std::floor(length / cell) + !periodic);
    };
    auto const cells = [&] {
        return Vector3{cells_along(extent.x, periods.x.on()), cells_along(extent.y, periods.y.on()),
                       cells_along(extent.z, false)};
    };
    // Far-flung particles must not make a huge empty grid: larger cells find the same pairs.
    double const most = 8.0 * static_cast<double>(places.size()) + 4096;
    Vector3 n = cells();
    for (; n.x * n.y * n.z > most; n = cells())
        cell *= 1.5;
    per_length_ = {periods.x.on() ? n.x / extent.x : 1 / cell, periods.y.on() ? n.y / extent.y : 1 / cell,
                   1 / cell};
    nx_ = static_cast<int>(n.x), ny_ = static_cast<int>(n.y), nz_ = static_cast<int>(n.z);
}

//! Cells along x follow one another, so a row of three cells is one range; across a periodic border it is
//! two.
CellGrid::Ranges CellGrid::forward_of(std::uint32_t cell) const
{
    int const number = static_cast<int>(cell);
    int const cx = number % nx_, cy = number / nx_ % ny_, cz = number / nx_ / ny_;
    Ranges forward;
    bool const wraps_x = periods_.x.on() && nx_ > 2;
    auto const row_start = [&](int y, int z) { return (z * ny_ + y) * nx_; };
    if (wraps_x && cx == nx_ - 1)
        forward.add(row_start(cy, cz), row_start(cy, cz));
    constexpr int rows[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}}; // (dy, dz)
    for (auto const& [dy, dz] : rows) {
        int y = cy + dy;
        int const z = cz + dz;
        if (periods_.y.on()) {
            // With one or two rows in the period, up and down lead to the same row.
            if ((ny_ == 1 && dy != 0) || (ny_ == 2 && (dy < 0 || (dz == 0 && cy == 1))))
                continue;
            y = (y + ny_) % ny_;
        }
        if (y < 0 || y >= ny_ || z >= nz_)
            continue;
        int const row = row_start(y, z);
        forward.add(row + std::max(cx - 1, 0), row + std::min(cx + 1, nx_ - 1));
        if (wraps_x && cx == 0)
            forward.add(row + nx_ - 1, row + nx_ - 1);
        if (wraps_x && cx == nx_ - 1)
            forward.add(row, row);
    }
    return forward;
}

} // namespace demens::dem
