#pragma once

#include "demens/base/vector3.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace demens::shape {

//! Spheres placed so far, filed by the cell of their centre; a cell is as wide as the largest sphere.
class PlacedSpheres
{
  public:
    //! \param cell at least the largest diameter [m] \param extent of the part of space that is filed in
    //! cells
    PlacedSpheres(Vector3 const& lower, Vector3 const& extent, double cell)
        : lower_(lower), inverse_cell_(1 / cell), nx_(count(extent.x)), ny_(count(extent.y)),
          nz_(count(extent.z)), cells_(static_cast<std::size_t>(nx_) * ny_ * nz_)
    {
    }

    //! Whether `is_it(place, radius)` holds for any sphere that may touch one at p.
    template <class Predicate>
    bool any_near(Vector3 const& p, Predicate&& is_it) const
    {
        int const x = index(p.x - lower_.x, nx_), y = index(p.y - lower_.y, ny_),
                  z = index(p.z - lower_.z, nz_);
        for (int cz = std::max(z - 1, 0); cz <= std::min(z + 1, nz_ - 1); ++cz)
            for (int cy = std::max(y - 1, 0); cy <= std::min(y + 1, ny_ - 1); ++cy)
                for (int cx = std::max(x - 1, 0); cx <= std::min(x + 1, nx_ - 1); ++cx)
                    for (auto const& [q, r] : cells_[at(cx, cy, cz)])
                        if (is_it(q, r))
                            return true;
        return false;
    }

    bool overlaps(Vector3 const& p, double radius) const
    {
        return any_near(
            p, [&](Vector3 const& q, double r) { return norm_squared(p - q) < (radius + r) * (radius + r); });
    }

    void add(Vector3 const& p, double radius)
    {
        cells_[at(index(p.x - lower_.x, nx_), index(p.y - lower_.y, ny_), index(p.z - lower_.z, nz_))]
            .push_back({p, radius});
    }

  private:
    int count(double extent) const { return 1 + static_cast<int>(extent * inverse_cell_); }
    int index(double offset, int n) const
    {
        return std::clamp(static_cast<int>(offset * inverse_cell_), 0, n - 1);
    }
    std::size_t at(int x, int y, int z) const { return (static_cast<std::size_t>(z) * ny_ + y) * nx_ + x; }

    Vector3 lower_;
    double inverse_cell_;
    int nx_, ny_, nz_;
    std::vector<std::vector<std::pair<Vector3, double>>> cells_;
};

} // namespace demens::shape
