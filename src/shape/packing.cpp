#include "demens/shape/packing.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace demens::shape {
namespace {

//! Spheres placed so far, filed by the cell of their centre; a cell is as wide as the largest sphere.
class PlacedSpheres
{
  public:
    PlacedSpheres(Vector3 const& lower, Vector3 const& extent, double cell)
        : lower_(lower), inverse_cell_(1 / cell), nx_(count(extent.x)), ny_(count(extent.y)),
          nz_(count(extent.z)), cells_(static_cast<std::size_t>(nx_) * ny_ * nz_)
    {
    }

    bool overlaps(Vector3 const& p, double radius) const
    {
        int const x = index(p.x - lower_.x, nx_), y = index(p.y - lower_.y, ny_),
                  z = index(p.z - lower_.z, nz_);
        for (int cz = std::max(z - 1, 0); cz <= std::min(z + 1, nz_ - 1); ++cz)
            for (int cy = std::max(y - 1, 0); cy <= std::min(y + 1, ny_ - 1); ++cy)
                for (int cx = std::max(x - 1, 0); cx <= std::min(x + 1, nx_ - 1); ++cx)
                    for (auto const& [q, r] : cells_[at(cx, cy, cz)])
                        if (norm_squared(p - q) < (radius + r) * (radius + r))
                            return true;
        return false;
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

} // namespace

std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random)
{
    if (diameters.empty())
        return {};
    double const largest = *std::max_element(diameters.begin(), diameters.end());
    if (largest >= std::min(width_x, width_y))
        throw InputError(
            fmt::format("no room for the particles: the largest sphere, {:.4g} mm, does not fit into a box "
                        "{:.4g} mm by {:.4g} mm",
                        1e3 * largest, 1e3 * width_x, 1e3 * width_y));
    double volume = 0;
    for (double const d : diameters)
        volume += std::numbers::pi / 6 * d * d * d;
    // Centres fill the box less half a sphere at the walls.
    double const room_x = width_x - largest, room_y = width_y - largest;
    double height = largest + volume / (solid_fraction * (room_x + 0.5 * largest) * (room_y + 0.5 * largest));

    // The largest first: small ones find the gaps.
    std::vector<std::size_t> order(diameters.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return diameters[a] > diameters[b]; });
    PlacedSpheres placed(lower, {width_x, width_y, 4 * height}, largest);
    std::vector<Vector3> places(diameters.size());
    for (std::size_t const k : order) {
        double const r = 0.5 * diameters[k];
        Vector3 p;
        int tries = 0;
        do {
            if (++tries % 200 == 0)
                height *= 1.02; // crowded: a little more height
            p = lower + Vector3{random.uniform(r, width_x - r), random.uniform(r, width_y - r),
                                random.uniform(r, height - r)};
        } while (placed.overlaps(p, r));
        placed.add(p, r);
        places[k] = p;
    }
    return places;
}

} // namespace demens::shape
