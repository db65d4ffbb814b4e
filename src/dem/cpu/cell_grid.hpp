#pragma once

#include "demens/base/vector3.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace demens::dem {

//! \throws InputError where a period is too short for particles up to a radius whose surfaces are within
//! reach of each other [m].
void check_periods(Periods const& periods, double largest_radius, double reach);

//! Cells of space by which particles are sorted, in rows along x and layers along x and y. Without periods
//! space is turned so that z is its longest direction: the smaller the layers, the more of their particles
//! stay in the cache.
class CellGrid
{
  public:
    //! Ranges of cells; those of a row follow one another.
    struct Ranges
    {
        std::uint32_t from[9], to[9]; //!< cell numbers; `to` is one past the last
        int count = 0;

        void add(int first, int last)
        {
            from[count] = static_cast<std::uint32_t>(first);
            to[count++] = static_cast<std::uint32_t>(last) + 1;
        }
    };

    //! Fits particles whose pairs are to be found within a reach of their surfaces [m]. Where few are much
    //! larger than the others, the cells are for those others: see `regular_radius`. Places must be finite,
    //! and within the periods. \throws InputError where a period is too short.
    CellGrid(std::vector<Place> const& places, double reach, Periods const& periods);

    std::size_t size() const { return static_cast<std::size_t>(nx_) * ny_ * nz_; }
    //! Particles up to this radius find their pairs in neighbouring cells; larger ones must look further [m].
    double regular_radius() const { return regular_radius_; }

    std::uint32_t cell_of(Place const& place) const
    {
        Vector3 const p = turned(place);
        auto const along = [](double offset, double per_length, int count) {
            return std::min(static_cast<int>(offset * per_length), count - 1);
        };
        return static_cast<std::uint32_t>(
            (along(p.z - lower_.z, per_length_.z, nz_) * ny_ + along(p.y - lower_.y, per_length_.y, ny_)) *
                nx_ +
            along(p.x - lower_.x, per_length_.x, nx_));
    }
    //! The forward half of a cell's neighbours, so that each pair of cells is met once. Of the own row, only
    //! what lies across a period: the rest is `end_of_own_row`.
    Ranges forward_of(std::uint32_t cell) const;
    //! One past the last cell of the own row that is a neighbour.
    std::uint32_t end_of_own_row(std::uint32_t cell) const
    {
        return cell + (static_cast<int>(cell) % nx_ + 1 < nx_ ? 2 : 1);
    }
    //! Visits each cell within some distance of a place once, also across the periods.
    template <class Visitor>
    void for_each_near(Place const& place, double distance, Visitor&& visit) const
    {
        Vector3 const p = turned(place);
        Span const x = span(p.x - lower_.x, distance, per_length_.x, nx_, periods_.x.on());
        Span const y = span(p.y - lower_.y, distance, per_length_.y, ny_, periods_.y.on());
        Span const z = span(p.z - lower_.z, distance, per_length_.z, nz_, false);
        for (int cz = z.from; cz < z.from + z.count; ++cz)
            for (int cy = y.from; cy < y.from + y.count; ++cy)
                for (int cx = x.from; cx < x.from + x.count; ++cx)
                    visit(static_cast<std::uint32_t>((cz * ny_ + cy % ny_) * nx_ + cx % nx_));
    }

  private:
    //! Cells in one direction; past the last one comes the first, across the period.
    struct Span
    {
        int from, count;
    };
    static Span span(double at, double distance, double per_length, int count, bool periodic)
    {
        int const from = static_cast<int>(std::floor((at - distance) * per_length));
        int const to = static_cast<int>(std::floor((at + distance) * per_length));
        if (periodic)
            return {(from % count + count) % count, std::min(to - from + 1, count)};
        int const inner_from = std::clamp(from, 0, count - 1), inner_to = std::clamp(to, 0, count - 1);
        return {inner_from, inner_to - inner_from + 1};
    }
    Vector3 turned(Place const& p) const
    {
        double const place[3] = {p.x, p.y, p.z};
        return {place[axes_[0]], place[axes_[1]], place[axes_[2]]};
    }

    Periods periods_;
    std::array<std::size_t, 3> axes_{0, 1, 2}; //!< of space, that are x, y and z here
    Vector3 lower_;
    Vector3 per_length_; //!< cells per length in each direction [1/m]
    int nx_, ny_, nz_;
    double regular_radius_;
};

} // namespace demens::dem
