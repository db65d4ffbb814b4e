#include "src/rig/custom/wall_seams.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

//! A point of a surface, with the normal there.
struct SurfacePoint
{
    Vector3 place, normal;
};

//! Points of the borders of a shape, where another may go on.
template <dem::Polygon Shape>
std::vector<SurfacePoint> border(Shape const& shape)
{
    std::vector<SurfacePoint> points;
    constexpr int pieces = 8; // of a side
    auto const all = corners(shape);
    for (std::size_t k = 0; k < all.size(); ++k)
        for (int piece = 0; piece < pieces; ++piece) {
            Vector3 const along = all[(k + 1) % all.size()] - all[k];
            Vector3 const place = all[k] + (static_cast<double>(piece) / pieces) * along;
            points.push_back({place, normal(shape, place)});
        }
    return points;
}

template <dem::RoundShape Shape>
std::vector<SurfacePoint> border(Shape const& shape)
{
    std::vector<SurfacePoint> points;
    if (side_of(shape) != dem::RoundSide::near)
        return points; // the same once more
    dem::Meridian const m = meridian(shape);
    Vector3 const u = any_normal_to(shape.axis), v = cross(shape.axis, u);
    constexpr int around = 32;
    for (int k = 0; k < around; ++k) {
        double const angle = 2 * std::numbers::pi * k / around;
        Vector3 const out = std::cos(angle) * u + std::sin(angle) * v;
        for (auto const& [height, radius] :
             {std::pair{m.height_start, m.radius_start}, std::pair{m.height_end, m.radius_end}})
            if (radius > 0) {
                Vector3 const place = shape.centre + height * shape.axis + radius * out;
                points.push_back({place, normal(shape, place)});
            }
    }
    return points;
}

std::vector<SurfacePoint> border(dem::Mesh const& mesh)
{
    std::vector<SurfacePoint> points;
    for (auto const& facet : mesh.mesh->facets())
        for (auto const vertex : facet.vertices)
            points.push_back(
                {mesh.placement(mesh.mesh->vertices()[vertex]), mesh.placement.rotation(facet.normal)});
    return points;
}

//! Whether a shape passes through a point, within a tolerance [m], in about the same plane.
template <class Shape>
bool goes_on_at(Shape const& shape, SurfacePoint const& point, double tolerance)
{
    return norm(point.place - nearest(shape, point.place)) < tolerance &&
           std::abs(dot(point.normal, normal(shape, point.place))) > 0.5;
}
bool goes_on_at(dem::Mesh const& mesh, SurfacePoint const& point, double tolerance)
{
    bool found = false;
    Vector3 const place = mesh.placement.inverse(point.place);
    mesh.mesh->tree().for_each_near(place, tolerance, [&](std::uint32_t triangle) {
        auto const& facet = mesh.mesh->facets()[triangle];
        found |= norm(facet.nearest(place).offset) < tolerance &&
                 std::abs(dot(point.normal, mesh.placement.rotation(facet.normal))) > 0.5;
    });
    return found;
}

//! Where the border of one wall goes on into another.
std::optional<Vector3> seam(WallPlan const& one, WallPlan const& other)
{
    for (auto const& part : one.parts)
        for (auto const& next : other.parts) {
            double const tolerance = 1e-6 * std::min(dem::extent(part.shape), dem::extent(next.shape));
            auto const points = std::visit([](auto const& shape) { return border(shape); }, part.shape);
            for (auto const& point : points)
                if (std::visit([&](auto const& shape) { return goes_on_at(shape, point, tolerance); },
                               next.shape))
                    return point.place;
        }
    return {};
}

bool is_mesh(WallPlan const& wall)
{
    return std::holds_alternative<dem::Mesh>(wall.parts.front().shape);
}

} // namespace

std::vector<std::string> seam_warnings(std::vector<WallPlan> const& walls)
{
    std::vector<std::string> warnings;
    for (std::size_t a = 0; a < walls.size(); ++a)
        for (std::size_t b = a + 1; b < walls.size(); ++b) {
            auto const &one = walls[a], &other = walls[b];
            bool const with_mesh = is_mesh(one) || is_mesh(other);
            if (one.material == other.material && !with_mesh)
                continue; // the engine joins them
            auto place = seam(one, other);
            if (!place)
                place = seam(other, one);
            if (place)
                warnings.push_back(
                    fmt::format("wall.{} and wall.{} go on into each other, e.g. at ({:.4g}, {:.4g}, {:.4g}) "
                                "mm, and {}: a "
                                "particle over the seam feels both, as if it were twice as stiff; {}",
                                one.name, other.name, 1e3 * place->x, 1e3 * place->y, 1e3 * place->z,
                                with_mesh ? "one is a mesh" : "are of different materials",
                                with_mesh ? "make them one mesh"
                                          : "give them one material, or leave a step between them"));
        }
    return warnings;
}

} // namespace demens::rig::custom
