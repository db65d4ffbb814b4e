#include "demens/grain/hull_sources.hpp"

#include "demens/base/error.hpp"
#include "demens/grain/mesh_mass.hpp"
#include "src/grain/point_table.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::grain {
namespace {

void check(SuperquadricHull const& shape, std::string const& origin)
{
    auto const refuse = [&](std::string const& what) { throw InputError(origin + ": " + what); };
    for (auto const& [name, ratio] :
         {std::pair{"horizontal", shape.horizontal_aspect}, std::pair{"vertical", shape.vertical_aspect}})
        if (!(ratio >= 0.01 && ratio <= 100))
            refuse(fmt::format("the {} aspect ratio {} must be from 0.01 to 100", name, ratio));
    if (shape.corners < 4 || shape.corners > static_cast<int>(most_vertices))
        refuse(fmt::format("the number of corners {} must be from 4 to {}", shape.corners, most_vertices));
    if (!(shape.degree >= 1.1 && shape.degree <= 20))
        refuse(
            fmt::format("the superquadric degree {} must be from 1.1 to 20 (2: an ellipsoid)", shape.degree));
}

//! Directions spread evenly over the sphere.
std::vector<Vector3> even_directions(int count)
{
    std::vector<Vector3> directions;
    double const golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int k = 0; k < count; ++k) {
        double const z = (2.0 * k + 1) / count - 1, radius = std::sqrt(1 - z * z), angle = golden_angle * k;
        directions.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    constexpr int rounds = 100;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Vector3> const before = directions;
        double const step = 0.5 / std::pow(count, 1.5) * (1 - round / static_cast<double>(rounds));
        for (std::size_t i = 0; i < before.size(); ++i) {
            Vector3 push;
            for (std::size_t j = 0; j < before.size(); ++j)
                if (Vector3 const apart = before[i] - before[j]; j != i)
                    push += apart / (norm_squared(apart) * norm(apart));
            Vector3 const moved = before[i] + step * push;
            directions[i] = moved / norm(moved);
        }
    }
    return directions;
}

} // namespace

Hull superquadric_hull(SuperquadricHull const& shape, std::string const& origin)
{
    check(shape, origin);
    double const n = shape.degree;
    std::vector<Vector3> corners;
    for (Vector3 const& d : even_directions(shape.corners)) {
        double const sum =
            std::pow(std::abs(d.x), n) + std::pow(std::abs(d.y), n) + std::pow(std::abs(d.z), n);
        double const half = 0.5 * std::pow(sum, -1 / n);
        corners.push_back(
            {half * shape.horizontal_aspect * d.x, half * d.y, half * shape.vertical_aspect * d.z});
    }
    return convex_hull(corners, origin);
}

SurfaceHull surface_hull(shape::TriangleMesh const& mesh, std::string const& origin)
{
    double const volume = mass_properties(mesh, origin).volume;
    SurfaceHull result{convex_hull(mesh.vertices(), origin), 0, ""};
    result.volume_error = volume_moments(result.hull).volume / volume - 1;
    constexpr double rounding = 1e-4; // of a surface in floats, and of what merging its faces takes
    if (result.volume_error > rounding)
        result.warning =
            fmt::format("{}: the surface is not convex: its hull is taken, whose volume is {:.1f} % "
                        "larger; a clump would keep the hollows",
                        origin, 100 * result.volume_error);
    return result;
}

Hull read_hull(std::string const& text, std::string const& origin, double scale)
{
    std::vector<Vector3> points;
    for (auto const& row : read_points(text, origin, {"x", "y", "z"}, scale).rows)
        points.push_back({row[0], row[1], row[2]});
    return convex_hull(points, origin);
}

} // namespace demens::grain
