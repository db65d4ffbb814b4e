#include "demens/grain/body_shape.hpp"

#include "demens/base/error.hpp"
#include "demens/grain/clump_fit.hpp"

#include <limits>

namespace demens::grain {
namespace {

//! Principal moments over mass and radius squared.
Vector3 relative_inertia(MassProperties const& properties, double radius)
{
    double const scale = 1 / (properties.volume * radius * radius);
    return scale * properties.moments;
}

shape::TriangleMesh mesh_of(Hull const& hull)
{
    shape::TriangleSoup triangles;
    auto const& vertices = hull.vertices();
    for (HullFace const& face : hull.faces()) {
        auto const corners = hull.corners(face);
        for (std::size_t k = 2; k < corners.size(); ++k)
            triangles.push_back({vertices[corners[0]], vertices[corners[k - 1]], vertices[corners[k]]});
    }
    return shape::TriangleMesh(triangles);
}

} // namespace

double BodyShape::reach(Vector3 const& direction) const
{
    double furthest = -std::numeric_limits<double>::infinity();
    if (hull) {
        for (Vector3 const& vertex : hull->core.vertices())
            furthest = std::max(furthest, dot(vertex, direction));
        return furthest + hull->rounding;
    }
    for (Ball const& ball : balls)
        furthest = std::max(furthest, dot(ball.place, direction) + ball.radius);
    return furthest;
}

BodyShape body_shape(std::span<Ball const> clump, std::string const& origin)
{
    check(clump, origin);
    if (clump.size() == 1)
        return {{{{}, 1}}, {0.4, 0.4, 0.4}};
    MassProperties const properties = mass_properties(clump);
    double const radius = 0.5 * properties.equivalent_diameter();
    return {scaled(in_principal_axes(clump, properties), 1 / radius),
            relative_inertia(properties, radius),
            {},
            properties.axes};
}

BodyShape body_shape(RoundedHull const& hull, std::string const& origin)
{
    if (!(hull.rounding > 0))
        throw InputError(origin + ": the edges of a hull that touches others need a rounding above 0");
    MassProperties const properties = mass_properties(hull);
    double const radius = 0.5 * properties.equivalent_diameter();
    RoundedHull const own = scaled(in_principal_axes(hull, properties), 1 / radius);
    return {outline(own, origin), relative_inertia(properties, radius), own, properties.axes};
}

Clump outline(RoundedHull const& hull, std::string const& origin)
{
    Clump balls = corner_balls(hull);
    auto const fit =
        fit_clump(mesh_of(hull.core), {.overlap = 0.9, .most_spheres = 24, .voxels = 40}, origin);
    for (Ball const& ball : fit.clump)
        balls.push_back({ball.place, ball.radius + hull.rounding});
    return balls;
}

} // namespace demens::grain
