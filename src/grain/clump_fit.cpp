#include "demens/grain/clump_fit.hpp"

#include "demens/base/error.hpp"
#include "demens/grain/mesh_mass.hpp"
#include "src/grain/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace demens::grain {
namespace {

//! Distance of a point from a surface [m], known to be below `reach`.
double distance_from(shape::TriangleMesh const& mesh, Vector3 const& p, double reach)
{
    double least = reach * reach;
    mesh.tree().for_each_near(p, reach, [&](std::uint32_t f) {
        least = std::min(least, norm_squared(mesh.facets()[f].nearest(p).offset));
    });
    return std::sqrt(least);
}

//! Dice's, of a body within another.
double dice(double within, double all)
{
    return 2 * within / (within + all);
}

//! Fills a surface, sphere by sphere.
class Filling
{
  public:
    Filling(shape::TriangleMesh const& mesh, int voxels)
        : mesh_(mesh), voxels_(mesh, voxels), open_(voxels_.inside()), depths_(voxels_.distances(open_)),
          inside_(std::accumulate(open_.begin(), open_.end(), std::size_t{0}))
    {
        for (std::size_t k = 0; k < voxels_.size(); ++k)
            if (voxels_.is_inside(k))
                inside_voxels_.push_back(k);
    }

    std::size_t inside() const { return inside_; }
    bool is_full() const { return covered_ == inside_; }
    //! Dice's, counted in voxels.
    double overlap() const { return dice(static_cast<double>(covered_), static_cast<double>(inside_)); }

    //! The next sphere, not yet counted.
    Ball next() const
    {
        std::vector<float> const gaps = voxels_.distances(open_);
        auto const peak = static_cast<std::size_t>(std::max_element(gaps.begin(), gaps.end()) - gaps.begin());
        Vector3 const held = voxels_.middle(peak);
        std::size_t best = peak;
        for (std::size_t const k : inside_voxels_) {
            if (depths_[k] <= depths_[best])
                continue;
            double const reach = voxels_.step() * depths_[k];
            if (norm_squared(voxels_.middle(k) - held) <= reach * reach)
                best = k;
        }
        return grown({voxels_.middle(best), depth(voxels_.middle(best), depths_[best])}, held);
    }

    void count(Ball const& ball)
    {
        voxels_.for_each_in(ball.place, ball.radius, [&](std::size_t k) {
            covered_ += static_cast<std::size_t>(open_[k]);
            open_[k] = 0;
        });
    }

  private:
    //! Exact, from what is known of it in voxels.
    double depth(Vector3 const& p, double voxels) const
    {
        return distance_from(mesh_, p, voxels_.step() * (voxels + 2));
    }

    //! Moved to where it is larger and still holds a point.
    Ball grown(Ball ball, Vector3 const& held) const
    {
        for (double step = 0.5 * voxels_.step(); step > 0.01 * voxels_.step(); step *= 0.5)
            for (bool better = true; better;) {
                better = false;
                for (Vector3 const& way : {Vector3{1, 0, 0}, Vector3{-1, 0, 0}, Vector3{0, 1, 0},
                                           Vector3{0, -1, 0}, Vector3{0, 0, 1}, Vector3{0, 0, -1}}) {
                    Vector3 const place = ball.place + step * way;
                    double const radius = distance_from(mesh_, place, ball.radius + 2 * step);
                    if (radius > ball.radius + 1e-3 * step && norm(place - held) <= radius) {
                        ball = {place, radius};
                        better = true;
                    }
                }
            }
        return ball;
    }

    shape::TriangleMesh const& mesh_;
    Voxels voxels_;
    std::vector<char> open_; //!< inside and not covered
    std::vector<float> depths_;
    std::size_t inside_, covered_ = 0;
    std::vector<std::size_t> inside_voxels_;
};

} // namespace

ClumpFit fit_clump(shape::TriangleMesh const& mesh, ClumpFitOptions const& options, std::string const& origin)
{
    MassProperties const surface = mass_properties(mesh, origin);
    Filling filling(mesh, options.voxels);
    if (filling.inside() == 0)
        throw InputError(fmt::format("{}: the surface is thinner than a voxel, {:.3g} m; raise the number of "
                                     "voxels above {}",
                                     origin, 2 * mesh.extent() / options.voxels, options.voxels));
    ClumpFit fit{};
    fit.end = ClumpFitEnd::most_spheres;
    double needed =
        options.overlap; // in voxels; spheres are put where they cover middles, which tell too much
    while (static_cast<int>(fit.clump.size()) < options.most_spheres) {
        Ball const ball = filling.next();
        if (ball.radius < options.smallest_radius) {
            fit.end = ClumpFitEnd::smallest_radius;
            break;
        }
        fit.clump.push_back(ball);
        filling.count(ball);
        if (filling.overlap() >= needed) {
            double const exact = dice(volume_moments(fit.clump).volume, surface.volume);
            if (exact >= options.overlap) {
                fit.end = ClumpFitEnd::overlap;
                break;
            }
            needed = filling.overlap() + (options.overlap - exact);
        }
        if (filling.is_full()) {
            fit.end = ClumpFitEnd::filled;
            break;
        }
    }
    if (fit.clump.empty())
        throw InputError(fmt::format("{}: no sphere of the smallest radius, {:.4g} m, fits into the surface",
                                     origin, options.smallest_radius));
    check(fit.clump, origin);
    MassProperties const found = mass_properties(fit.clump);
    fit.overlap = dice(found.volume, surface.volume);
    fit.volume_error = found.volume / surface.volume - 1;
    fit.centre_error = norm(found.centre - surface.centre);
    fit.inertia_error = frobenius(found.inertia + -1 * surface.inertia) / frobenius(surface.inertia);
    return fit;
}

} // namespace demens::grain
