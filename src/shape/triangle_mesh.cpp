#include "demens/shape/triangle_mesh.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace demens::shape {
namespace {

std::string at_place(Vector3 const& p)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", p.x, p.y, p.z);
}

//! Joins points that are nearer than a tolerance.
class Welder
{
  public:
    Welder(Vector3 const& origin, double tolerance) : origin_(origin), tolerance_(tolerance) {}

    //! Number of the vertex at p, a new one if there is none yet.
    std::uint32_t vertex_at(Vector3 const& p)
    {
        Vector3 const relative = (p - origin_) / tolerance_;
        std::array<std::int64_t, 3> const cell = {std::llround(relative.x), std::llround(relative.y),
                                                  std::llround(relative.z)};
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    auto const found = cells_.find({cell[0] + dx, cell[1] + dy, cell[2] + dz});
                    if (found != cells_.end() && norm(vertices[found->second] - p) <= tolerance_)
                        return found->second;
                }
        auto const number = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(p);
        cells_.emplace(cell, number);
        return number;
    }

    std::vector<Vector3> vertices;

  private:
    struct Hash
    {
        std::size_t operator()(std::array<std::int64_t, 3> const& cell) const
        {
            std::uint64_t hash = 0;
            for (std::int64_t const c : cell)
                hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
            return hash ^ hash >> 32;
        }
    };
    Vector3 origin_;
    double tolerance_;
    std::unordered_map<std::array<std::int64_t, 3>, std::uint32_t, Hash> cells_;
};

} // namespace

std::vector<std::string> MeshFaults::warnings() const
{
    std::vector<std::string> lines;
    auto const count = [](std::size_t number, std::string const& what) {
        return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
    };
    if (degenerate > 0)
        lines.push_back(fmt::format("{} without area left out, the first at {}",
                                    count(degenerate, "triangle"), at_place(first_degenerate)));
    if (open_edges > 0)
        lines.push_back(
            fmt::format("{} with one triangle only, the first at {}: the surface is open, or has a hole",
                        count(open_edges, "edge"), at_place(first_open_edge)));
    if (manifold_faults > 0)
        lines.push_back(fmt::format("{} with more than two triangles, the first at {}: sheets meet there, or "
                                    "triangles are listed twice",
                                    count(manifold_faults, "edge"), at_place(first_manifold_fault)));
    return lines;
}

TriangleMesh::TriangleMesh(TriangleSoup const& soup) : tree_({})
{
    for (std::size_t k = 0; k < soup.size(); ++k)
        for (Vector3 const& p : soup[k])
            if (!std::isfinite(p.x + p.y + p.z))
                throw InputError(
                    fmt::format("a corner of triangle {} of {} is not a finite number", k + 1, soup.size()));
    if (soup.empty())
        throw InputError("the mesh has no triangles");
    bounds_ = {soup[0][0], soup[0][0]};
    for (auto const& triangle : soup)
        for (Vector3 const& p : triangle)
            bounds_.include(p);
    join(soup);
    if (facets_.empty())
        throw InputError(fmt::format("none of the mesh's {} triangles has an area", soup.size()));
    complete();
}

TriangleMesh TriangleMesh::from_parts(Parts const& parts)
{
    TriangleMesh mesh;
    mesh.bounds_ = parts.bounds;
    mesh.vertices_ = parts.vertices;
    if (parts.triangles.empty())
        throw InputError("the mesh has no triangles");
    for (auto const& triangle : parts.triangles) {
        for (auto const vertex : triangle)
            if (vertex >= mesh.vertices_.size())
                throw InputError(fmt::format("a triangle of the mesh names the vertex {} of {}", vertex,
                                             mesh.vertices_.size()));
        mesh.add_facet(triangle);
    }
    mesh.complete();
    return mesh;
}

TriangleMesh::Parts TriangleMesh::parts() const
{
    Parts parts{vertices_, {}, bounds_};
    for (Facet const& facet : facets_)
        parts.triangles.push_back(facet.vertices);
    return parts;
}

void TriangleMesh::complete()
{
    centre_ = 0.5 * (bounds_.lower + bounds_.upper);
    for (Vector3 const& p : vertices_)
        extent_ = std::max(extent_, norm(p - centre_));
    find_edges();
    tree_ = TriangleTree(facet_bounds());
}

void TriangleMesh::join(TriangleSoup const& soup)
{
    double const tolerance = std::max(1e-6 * norm(bounds_.upper - bounds_.lower), 1e-300);
    Welder welder(bounds_.lower, tolerance);
    std::vector<std::array<std::uint32_t, 3>> with_area;
    for (auto const& triangle : soup) {
        std::array<std::uint32_t, 3> const vertices = {
            welder.vertex_at(triangle[0]), welder.vertex_at(triangle[1]), welder.vertex_at(triangle[2])};
        Vector3 const corner = welder.vertices[vertices[0]];
        Vector3 const side_1 = welder.vertices[vertices[1]] - corner;
        Vector3 const side_2 = welder.vertices[vertices[2]] - corner;
        double const longest =
            std::sqrt(std::max({norm_squared(side_1), norm_squared(side_2), norm_squared(side_2 - side_1)}));
        if (norm(cross(side_1, side_2)) <= tolerance * longest) { // lower than the tolerance
            if (faults_.degenerate++ == 0)
                faults_.first_degenerate = corner;
            continue;
        }
        with_area.push_back(vertices);
    }
    vertices_ = std::move(welder.vertices);
    for (auto const& vertices : with_area)
        add_facet(vertices);
}

void TriangleMesh::add_facet(std::array<std::uint32_t, 3> const& vertices)
{
    Vector3 const corner = vertices_[vertices[0]];
    Vector3 const side_1 = vertices_[vertices[1]] - corner, side_2 = vertices_[vertices[2]] - corner;
    Vector3 const across = cross(side_1, side_2);
    double const d11 = norm_squared(side_1), d12 = dot(side_1, side_2), d22 = norm_squared(side_2);
    facets_.push_back({corner, across / norm(across), side_1, side_2, d11, d12, d22,
                       1 / (d11 * d22 - d12 * d12), vertices});
}

void TriangleMesh::find_edges()
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, MeshEdge> edges;
    for (std::uint32_t f = 0; f < facets_.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            auto const [a, b] = std::minmax(facets_[f].vertices[k], facets_[f].vertices[(k + 1) % 3]);
            MeshEdge& edge = edges[{a, b}];
            edge.vertices = {a, b};
            if (edge.facet_count < 2)
                edge.facets[edge.facet_count] = f;
            ++edge.facet_count;
        }
    for (auto const& [vertices, edge] : edges) {
        edges_.push_back(edge);
        Vector3 const middle = 0.5 * (vertices_[edge.vertices[0]] + vertices_[edge.vertices[1]]);
        if (edge.facet_count == 1 && faults_.open_edges++ == 0)
            faults_.first_open_edge = middle;
        if (edge.facet_count > 2 && faults_.manifold_faults++ == 0)
            faults_.first_manifold_fault = middle;
    }
}

std::vector<Bounds> TriangleMesh::facet_bounds() const
{
    std::vector<Bounds> bounds;
    bounds.reserve(facets_.size());
    for (Facet const& facet : facets_) {
        bounds.push_back({facet.corner, facet.corner});
        bounds.back().include(facet.corner + facet.side_1);
        bounds.back().include(facet.corner + facet.side_2);
    }
    return bounds;
}

TriangleSoup box_triangles(Vector3 const& lower, Vector3 const& upper)
{
    auto const corner = [&](int k) {
        return Vector3{k & 1 ? upper.x : lower.x, k & 2 ? upper.y : lower.y, k & 4 ? upper.z : lower.z};
    };
    // Corners of each side, counter-clockwise seen from outside.
    constexpr int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    TriangleSoup soup;
    for (auto const& [a, b, c, d] : sides) {
        soup.push_back({corner(a), corner(b), corner(c)});
        soup.push_back({corner(a), corner(c), corner(d)});
    }
    return soup;
}

} // namespace demens::shape
