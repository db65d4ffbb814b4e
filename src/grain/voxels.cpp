#include "src/grain/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::grain {
namespace {

//! Where the line along z through a point meets a facet, if it does.
bool height_of(shape::Facet const& facet, double x, double y, double& z)
{
    Vector3 const &a = facet.side_1, &b = facet.side_2;
    double const area = a.x * b.y - a.y * b.x;
    double const px = x - facet.corner.x, py = y - facet.corner.y;
    double const s = (px * b.y - py * b.x) / area, t = (a.x * py - a.y * px) / area;
    if (area == 0 || !(s >= 0 && t >= 0 && s + t <= 1))
        return false;
    z = facet.corner.z + s * a.z + t * b.z;
    return true;
}

//! Squares of distances along a line, from those across it: the lower envelope of parabolas.
class LineTransform
{
  public:
    //! In place, for n values a stride apart.
    void operator()(float* values, int n, std::size_t stride)
    {
        corners_.resize(static_cast<std::size_t>(n));
        borders_.resize(static_cast<std::size_t>(n) + 1);
        line_.resize(static_cast<std::size_t>(n));
        for (int k = 0; k < n; ++k)
            line_[static_cast<std::size_t>(k)] = values[static_cast<std::size_t>(k) * stride];
        constexpr float infinity = std::numeric_limits<float>::infinity();
        std::size_t last = 0;
        corners_[0] = 0;
        borders_[0] = -infinity;
        borders_[1] = infinity;
        for (int k = 1; k < n; ++k) {
            float border = crossing(k, corners_[last]);
            while (border <= borders_[last])
                border = crossing(k, corners_[--last]);
            corners_[++last] = k;
            borders_[last] = border;
            borders_[last + 1] = infinity;
        }
        std::size_t piece = 0;
        for (int k = 0; k < n; ++k) {
            while (borders_[piece + 1] < static_cast<float>(k))
                ++piece;
            auto const d = static_cast<float>(k - corners_[piece]);
            values[static_cast<std::size_t>(k) * stride] =
                d * d + line_[static_cast<std::size_t>(corners_[piece])];
        }
    }

  private:
    //! Where the parabolas with their corners at p and q are equal.
    float crossing(int p, int q) const
    {
        auto const at = [&](int k) { return line_[static_cast<std::size_t>(k)] + static_cast<float>(k * k); };
        return (at(p) - at(q)) / static_cast<float>(2 * (p - q));
    }
    std::vector<int> corners_;
    std::vector<float> borders_, line_;
};

} // namespace

Voxels::Voxels(shape::TriangleMesh const& mesh, int across)
{
    shape::Bounds const& bounds = mesh.bounds();
    Vector3 const extent = bounds.upper - bounds.lower;
    step_ = std::max({extent.x, extent.y, extent.z}) / across;
    auto const count = [&](double along) { return static_cast<int>(std::ceil(along / step_)) + 2; };
    nx_ = count(extent.x), ny_ = count(extent.y), nz_ = count(extent.z);
    // A little beside the middle, so that no line meets the edges of a surface that is symmetric.
    Vector3 const beside{0.0141421356, 0.0173205081, 0.0223606798};
    lower_ = 0.5 * (bounds.lower + bounds.upper) - 0.5 * step_ * Vector3{1.0 * nx_, 1.0 * ny_, 1.0 * nz_} +
             step_ * beside;
    inside_.assign(at(0, 0, nz_), 0);
    std::vector<std::vector<std::uint32_t>> facets(at(0, 0, 1)); // over each column
    for (std::uint32_t f = 0; f < mesh.facets().size(); ++f) {
        shape::Facet const& facet = mesh.facets()[f];
        shape::Bounds over{facet.corner, facet.corner};
        over.include(facet.corner + facet.side_1);
        over.include(facet.corner + facet.side_2);
        Vector3 const from = (over.lower - lower_) / step_, to = (over.upper - lower_) / step_;
        for (int y = first(from.y - 1); y <= last(to.y, ny_); ++y)
            for (int x = first(from.x - 1); x <= last(to.x, nx_); ++x)
                facets[at(x, y, 0)].push_back(f);
    }
    for (int y = 0; y < ny_; ++y)
        for (int x = 0; x < nx_; ++x)
            fill_column(mesh, x, y, facets);
}

void Voxels::fill_column(shape::TriangleMesh const& mesh, int x, int y,
                         std::vector<std::vector<std::uint32_t>> const& facets)
{
    std::vector<double> heights;
    for (auto const f : facets[at(x, y, 0)]) {
        double z = 0;
        if (height_of(mesh.facets()[f], lower_.x + step_ * (x + 0.5), lower_.y + step_ * (y + 0.5), z))
            heights.push_back((z - lower_.z) / step_ - 0.5);
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 0; k + 1 < heights.size(); k += 2)
        for (int z = first(std::ceil(heights[k])); z <= last(heights[k + 1], nz_); ++z)
            inside_[at(x, y, z)] = 1;
}

Vector3 Voxels::middle(std::size_t voxel) const
{
    std::size_t const row = voxel / static_cast<std::size_t>(nx_),
                      layer = row / static_cast<std::size_t>(ny_);
    auto const x = static_cast<double>(voxel % static_cast<std::size_t>(nx_));
    auto const y = static_cast<double>(row % static_cast<std::size_t>(ny_));
    return lower_ + step_ * Vector3{x + 0.5, y + 0.5, static_cast<double>(layer) + 0.5};
}

std::vector<float> Voxels::distances(std::vector<char> const& marked) const
{
    constexpr float far = 1e12F; // finite, so that differences are
    std::vector<float> result(marked.size());
    for (std::size_t k = 0; k < marked.size(); ++k)
        result[k] = marked[k] ? far : 0;
    LineTransform transform;
    auto const row = static_cast<std::size_t>(nx_), layer = at(0, 0, 1);
    for (int z = 0; z < nz_; ++z)
        for (int y = 0; y < ny_; ++y)
            transform(&result[at(0, y, z)], nx_, 1);
    for (int z = 0; z < nz_; ++z)
        for (int x = 0; x < nx_; ++x)
            transform(&result[at(x, 0, z)], ny_, row);
    for (int y = 0; y < ny_; ++y)
        for (int x = 0; x < nx_; ++x)
            transform(&result[at(x, y, 0)], nz_, layer);
    for (float& d : result)
        d = std::sqrt(d);
    return result;
}

} // namespace demens::grain
