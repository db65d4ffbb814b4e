#include "demens/observe/wall_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::observe {
namespace {

void add_line(Snapshot& snapshot, Vector3 const& a, Vector3 const& b)
{
    snapshot.wall_lines.push_back({a.x, a.y, a.z, b.x, b.y, b.z});
}

void add_triangle(Snapshot& snapshot, Vector3 const& a, Vector3 const& b, Vector3 const& c)
{
    snapshot.wall_triangles.push_back({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
}

//! Whether a direction is that of an axis.
bool is_along_axis(Vector3 const& unit)
{
    return std::max({std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)}) > 1 - 1e-12;
}

template <dem::Polygon Shape>
void add(Snapshot& snapshot, Shape const& shape)
{
    auto const all = corners(shape);
    for (std::size_t k = 0; k < all.size(); ++k)
        add_line(snapshot, all[k], all[(k + 1) % all.size()]);
    for (std::size_t k = 2; k < all.size(); ++k)
        add_triangle(snapshot, all[0], all[k - 1], all[k]);
}

void add(Snapshot& snapshot, dem::Rectangle const& r)
{
    if (!is_along_axis(cross(r.axis_u, r.axis_v)) || !is_along_axis(r.axis_u))
        return add<dem::Rectangle>(snapshot, r);
    auto const all = corners(r);
    Vector3 const &a = all[0], &b = all[2];
    snapshot.walls.push_back({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z), std::max(a.x, b.x),
                              std::max(a.y, b.y), std::max(a.z, b.z)});
}

template <dem::RoundShape Shape>
void add(Snapshot& snapshot, Shape const& shape)
{
    if (dem::side_of(shape) != dem::RoundSide::near)
        return;                                         // the same once more
    constexpr int around = 64, every_side = around / 4; // four lines along the sides
    dem::Meridian const m = meridian(shape);
    Vector3 const u = any_normal_to(shape.axis), v = cross(shape.axis, u);
    auto const point = [&](double height, double radius, int k) {
        double const angle = 2 * std::numbers::pi * (k % around) / around;
        return shape.centre + height * shape.axis + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int k = 0; k < around; ++k) {
        Vector3 const start = point(m.height_start, m.radius_start, k);
        Vector3 const next_start = point(m.height_start, m.radius_start, k + 1);
        Vector3 const end = point(m.height_end, m.radius_end, k);
        Vector3 const next_end = point(m.height_end, m.radius_end, k + 1);
        if (m.radius_start > 0) {
            add_line(snapshot, start, next_start);
            add_triangle(snapshot, start, next_start, next_end);
        }
        if (m.radius_end > 0) {
            add_line(snapshot, end, next_end);
            add_triangle(snapshot, start, next_end, end);
        }
        if (m.height_start != m.height_end && k % every_side == 0)
            add_line(snapshot, start, end);
    }
}

void add(Snapshot& snapshot, dem::Mesh const& wall)
{
    shape::TriangleMesh const& mesh = *wall.mesh;
    double const crease = std::cos(30 * std::numbers::pi / 180);
    auto const corner = [&](std::uint32_t vertex) { return wall.placement(mesh.vertices()[vertex]); };
    for (shape::MeshEdge const& edge : mesh.edges()) {
        bool const smooth =
            edge.facet_count == 2 && std::abs(dot(mesh.facets()[edge.facets[0]].normal,
                                                  mesh.facets()[edge.facets[1]].normal)) > crease;
        if (!smooth)
            add_line(snapshot, corner(edge.vertices[0]), corner(edge.vertices[1]));
    }
    for (shape::Facet const& facet : mesh.facets())
        add_triangle(snapshot, corner(facet.vertices[0]), corner(facet.vertices[1]),
                     corner(facet.vertices[2]));
}

} // namespace

void add_outline(Snapshot& snapshot, dem::Wall const& wall)
{
    std::visit([&](auto const& shape) { add(snapshot, shape); }, wall.shape);
}

} // namespace demens::observe
