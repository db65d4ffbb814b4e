#pragma once

#include "demens/shape/triangle_mesh.hpp"

#include <vector>

namespace demens::grain {

//! Cubes around a surface, a layer more on each side, and which of them have their middle inside.
class Voxels
{
  public:
    //! \param across number of voxels along the longest side of the surface's bounds
    Voxels(shape::TriangleMesh const& mesh, int across);

    double step() const { return step_; } //!< side of a voxel [m]
    std::size_t size() const { return inside_.size(); }
    bool is_inside(std::size_t voxel) const { return inside_[voxel]; }
    Vector3 middle(std::size_t voxel) const;

    //! Distance [voxels] of each voxel's middle from the nearest one that is not marked (Felzenszwalb &
    //! Huttenlocher 2012), 0 where it is not itself.
    std::vector<float> distances(std::vector<char> const& marked) const;
    std::vector<char> const& inside() const { return inside_; }

    //! Calls visit(voxel) for each voxel whose middle lies within a ball.
    template <class Visit>
    void for_each_in(Vector3 const& centre, double radius, Visit&& visit) const
    {
        Vector3 const c = (centre - lower_) / step_;
        double const r = radius / step_;
        for (int z = first(c.z - r); z <= last(c.z + r, nz_); ++z)
            for (int y = first(c.y - r); y <= last(c.y + r, ny_); ++y)
                for (int x = first(c.x - r); x <= last(c.x + r, nx_); ++x) {
                    Vector3 const apart = Vector3{x + 0.5, y + 0.5, z + 0.5} - c;
                    if (norm_squared(apart) <= r * r)
                        visit(at(x, y, z));
                }
    }

  private:
    static int first(double from) { return from > 0 ? static_cast<int>(from) : 0; }
    static int last(double to, int n) { return to < n - 1 ? static_cast<int>(to) : n - 1; }
    std::size_t at(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(nx_) +
               static_cast<std::size_t>(x);
    }
    void fill_column(shape::TriangleMesh const& mesh, int x, int y,
                     std::vector<std::vector<std::uint32_t>> const& facets);

    Vector3 lower_;
    double step_;
    int nx_, ny_, nz_;
    std::vector<char> inside_;
};

} // namespace demens::grain
