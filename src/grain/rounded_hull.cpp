#include "demens/grain/rounded_hull.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace demens::grain {
namespace {

//! a b^T + b a^T.
SymmetricTensor both_products(Vector3 const& a, Vector3 const& b)
{
    return 2 * products(a, b);
}

//! What lies within r above a face: an upright prism.
VolumeMoments prism_on(Hull const& hull, HullFace const& face, double r)
{
    auto const loop = hull.corners(face);
    Vector3 const& n = face.normal;
    auto const corner = [&](std::size_t k) { return hull.vertices()[loop[k]]; };
    double area = 0;
    Vector3 first;
    SymmetricTensor second;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        Vector3 const a = corner(0), b = corner(k), c = corner(k + 1), sum = a + b + c;
        double const part = 0.5 * dot(n, cross(b - a, c - a));
        area += part;
        first += part / 3 * sum;
        second += part / 12 * (products(sum) + products(a) + products(b) + products(c));
    }
    return {area * r, r * first + 0.5 * area * r * r * n,
            r * second + 0.5 * r * r * both_products(first, n) + area * r * r * r / 3 * products(n)};
}

//! Angle between unit vectors [rad], precise for small ones too.
double angle_between(Vector3 const& a, Vector3 const& b)
{
    return std::atan2(norm(cross(a, b)), dot(a, b));
}

//! What lies within r of an edge and beyond the prisms of its faces: a wedge of a cylinder.
VolumeMoments wedge_along(Hull const& hull, HullEdge const& edge, double r)
{
    Vector3 const from = hull.vertices()[edge.vertices[0]], to = hull.vertices()[edge.vertices[1]];
    Vector3 const n1 = hull.faces()[edge.faces[0]].normal, n2 = hull.faces()[edge.faces[1]].normal;
    double const length = norm(to - from), angle = angle_between(n1, n2);
    Vector3 const bisector = (n1 + n2) / norm(n1 + n2), across = (n2 - n1) / norm(n2 - n1);
    // Integrals along the edge of the place and its products, over the angle of the normal and its products.
    Vector3 const middle = 0.5 * (from + to), place = length * middle;
    SymmetricTensor const places = length * (products(middle) + 1.0 / 12 * products(to - from));
    Vector3 const normal = 2 * std::sin(0.5 * angle) * bisector;
    SymmetricTensor const normals = 0.5 * (angle + std::sin(angle)) * products(bisector) +
                                    0.5 * (angle - std::sin(angle)) * products(across);
    double const r2 = 0.5 * r * r, r3 = r * r * r / 3, r4 = 0.25 * r * r * r * r;
    return {r2 * angle * length, r2 * angle * place + r3 * length * normal,
            r2 * angle * places + r3 * both_products(place, normal) + r4 * length * normals};
}

//! What lies within r of a corner and beyond the wedges of its edges: a sector of a ball, over the spherical
//! polygon of the normals at the corner. Its solid angle is the corner's defect of angles (Gauss); the
//! integrals over it of the normal and its products follow from those along its arcs, since these are
//! eigenfunctions of the sphere's Laplacian (to -2 and, without their trace, to -6), and the direction out of
//! an arc is that of its edge.
VolumeMoments sector_at(Hull const& hull, std::size_t vertex, double r)
{
    Vector3 const place = hull.vertices()[vertex];
    double solid_angle = 2 * std::numbers::pi;
    for (auto const f : hull.faces_of_vertices()[vertex]) {
        auto const loop = hull.corners(hull.faces()[f]);
        auto const at = static_cast<std::size_t>(
            std::find(loop.begin(), loop.end(), static_cast<std::uint16_t>(vertex)) - loop.begin());
        Vector3 const next = hull.vertices()[loop[(at + 1) % loop.size()]] - place;
        Vector3 const before = hull.vertices()[loop[(at + loop.size() - 1) % loop.size()]] - place;
        solid_angle -= angle_between(next / norm(next), before / norm(before));
    }
    double const third = solid_angle / 3;
    Vector3 normal;
    SymmetricTensor normals{third, third, third};
    for (HullEdge const& edge : hull.edges()) {
        if (edge.vertices[0] != vertex && edge.vertices[1] != vertex)
            continue;
        auto const other = edge.vertices[0] == vertex ? edge.vertices[1] : edge.vertices[0];
        Vector3 const along = hull.vertices()[other] - place, out = along / norm(along);
        Vector3 const n1 = hull.faces()[edge.faces[0]].normal, n2 = hull.faces()[edge.faces[1]].normal;
        double const angle = angle_between(n1, n2);
        normal -= 0.5 * angle * out;
        Vector3 const on_arc = (2 * std::sin(0.5 * angle) / norm(n1 + n2)) * (n1 + n2);
        normals += -1.0 / 6 * both_products(out, on_arc);
    }
    double const r3 = r * r * r / 3, r4 = 0.25 * r * r * r * r, r5 = 0.2 * r * r * r * r * r;
    return {r3 * solid_angle, r3 * solid_angle * place + r4 * normal,
            r3 * solid_angle * products(place) + r4 * both_products(place, normal) + r5 * normals};
}

//! Places of the corners when all faces move inwards by r: where its faces meet, or of more than three, which
//! need not meet in one, the place nearest to all of them (least squares). None where a face is missed by
//! more than `tolerance` [m].
std::vector<Vector3> corners_moved_inwards(Hull const& hull, double r, double tolerance)
{
    std::vector<Vector3> corners;
    for (std::size_t v = 0; v < hull.vertices().size(); ++v) {
        Vector3 x, y, z, sum; // columns of the sum of n n^T; sum of n
        for (auto const f : hull.faces_of_vertices()[v]) {
            Vector3 const& n = hull.faces()[f].normal;
            x += n.x * n, y += n.y * n, z += n.z * n, sum += n;
        }
        double const determinant = dot(x, cross(y, z));
        if (!(determinant > 1e-9))
            return {};
        Vector3 const step =
            (-r / determinant) * Vector3{dot(sum, cross(y, z)), dot(x, cross(sum, z)), dot(x, cross(y, sum))};
        for (auto const f : hull.faces_of_vertices()[v])
            if (std::abs(dot(hull.faces()[f].normal, step) + r) > tolerance)
                return {};
        corners.push_back(hull.vertices()[v] + step);
    }
    return corners;
}

} // namespace

RoundedHull rounded(Hull const& hull, double rounding, std::string const& origin)
{
    if (rounding == 0)
        return {hull, 0};
    VolumeMoments const moments = volume_moments(hull);
    Vector3 const centre = moments.first / moments.volume;
    double nearest = std::numeric_limits<double>::infinity();
    for (HullFace const& face : hull.faces())
        nearest = std::min(nearest, face.offset - dot(face.normal, centre));
    if (!(rounding > 0 && rounding < 0.999 * nearest))
        throw InputError(
            fmt::format("{}: the edges cannot be rounded with a radius of {:.4g} m: it must be at "
                        "least 0 and below {:.4g} m, the distance of the centre from the nearest "
                        "face",
                        origin, rounding, 0.999 * nearest));
    // Planes n . x = h around the centre become points n / h; the hull of these has a side for each corner.
    std::vector<Vector3> points;
    for (HullFace const& face : hull.faces())
        points.push_back(face.normal / (face.offset - dot(face.normal, centre) - rounding));
    Hull const dual = convex_hull(points, origin);
    std::vector<Vector3> corners;
    for (HullFace const& side : dual.faces())
        corners.push_back(centre + side.normal / side.offset);
    Hull core = convex_hull(corners, origin);
    if (core.vertices().size() <= hull.vertices().size())
        return {std::move(core), rounding};
    // Corners of more than three faces have come apart, into some that are near to each other.
    auto const together = corners_moved_inwards(hull, rounding, 0.25 * rounding);
    if (together.empty())
        return {std::move(core), rounding};
    Hull same = convex_hull(together, origin);
    if (same.vertices().size() == hull.vertices().size() && same.faces().size() == hull.faces().size())
        return {std::move(same), rounding};
    return {std::move(core), rounding};
}

VolumeMoments volume_moments(RoundedHull const& hull)
{
    VolumeMoments moments = volume_moments(hull.core);
    if (hull.rounding == 0)
        return moments;
    for (HullFace const& face : hull.core.faces())
        moments += prism_on(hull.core, face, hull.rounding);
    for (HullEdge const& edge : hull.core.edges())
        moments += wedge_along(hull.core, edge, hull.rounding);
    for (std::size_t v = 0; v < hull.core.vertices().size(); ++v)
        moments += sector_at(hull.core, v, hull.rounding);
    return moments;
}

MassProperties mass_properties(RoundedHull const& hull)
{
    return mass_properties_of(volume_moments(hull));
}

Clump corner_balls(RoundedHull const& hull)
{
    Clump balls;
    for (Vector3 const& v : hull.core.vertices())
        balls.push_back({v, hull.rounding});
    return balls;
}

RoundedHull scaled(RoundedHull const& hull, double factor)
{
    return {hull.core.scaled(factor), factor * hull.rounding};
}

RoundedHull in_principal_axes(RoundedHull const& hull, MassProperties const& properties)
{
    return {hull.core.seen_from(properties.centre, properties.axes), hull.rounding};
}

} // namespace demens::grain
