#include "src/dem/cpu/hulls/mesh_features.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

// Cosines between what goes on from an edge or a corner and the side to which all of it does.
constexpr double bent = 1e-4;  //!< least of what stands out
constexpr double sharp = 0.17; //!< least of what is sharp: the triangles of an edge bend by some 20 degrees
constexpr double behind = 0.5; //!< most with which a direction is not one from behind
constexpr double little = 1e-6;

Vector3 unit(Vector3 const& v)
{
    return v / norm(v);
}

} // namespace

MeshFeatures::MeshFeatures(shape::TriangleMesh const& mesh)
{
    find_edges(mesh);
    find_corners(mesh);
    auto const& facets = mesh.facets();
    may_touch_.assign(facets.size(), {0, 0});
    for (std::size_t t = 0; t < facets.size(); ++t)
        for (unsigned k = 0; k < 3; ++k)
            for (std::size_t side = 0; side < 2; ++side) {
                Vector3 const normal = side == 0 ? facets[t].normal : -facets[t].normal;
                may_touch_[t][side] |= static_cast<char>(may_touch(edges_[edges_of_[t][k]].stands, normal) ||
                                                         may_touch(corners_[facets[t].vertices[k]], normal));
            }
}

MeshFeatures::Stand MeshFeatures::stand(Vector3 const* directions, std::size_t count)
{
    Vector3 sum;
    for (std::size_t k = 0; k < count; ++k)
        sum += directions[k];
    if (norm(sum) < bent)
        return {};
    Stand found{Kind::sharp, unit(sum)};
    for (std::size_t k = 0; k < count; ++k) {
        double const along = dot(directions[k], found.side);
        if (along < bent)
            return {};
        if (along < sharp)
            found.kind = Kind::gentle;
    }
    return found;
}

bool MeshFeatures::may_touch(Stand const& stand, Vector3 const& normal)
{
    return stand.kind != Kind::flat && dot(stand.side, normal) < behind;
}

bool MeshFeatures::touches(Stand const& stand, Vector3 const& direction, Vector3 const* directions,
                           std::size_t count)
{
    return may_touch(stand, direction) &&
           (stand.kind == Kind::sharp || std::all_of(directions, directions + count, [&](Vector3 const& on) {
                return dot(on, direction) < little;
            }));
}

void MeshFeatures::find_edges(shape::TriangleMesh const& mesh)
{
    auto const& vertices = mesh.vertices();
    auto const& facets = mesh.facets();
    auto const& edges = mesh.edges(); // in the order of their vertices
    edges_of_.resize(facets.size());
    for (std::size_t t = 0; t < facets.size(); ++t)
        for (unsigned k = 0; k < 3; ++k) {
            std::uint32_t const a = facets[t].vertices[k], b = facets[t].vertices[(k + 1) % 3];
            std::array const ends{std::min(a, b), std::max(a, b)};
            auto const found = std::lower_bound(
                edges.begin(), edges.end(), ends,
                [](shape::MeshEdge const& edge, auto const& of) { return edge.vertices < of; });
            edges_of_[t][k] = static_cast<std::uint32_t>(found - edges.begin());
        }
    for (shape::MeshEdge const& edge : edges) {
        Vector3 const from = vertices[edge.vertices[0]], along = unit(vertices[edge.vertices[1]] - from);
        std::size_t const count = std::min<std::size_t>(2, edge.facet_count);
        Edge made;
        for (std::size_t k = 0; k < count; ++k)
            for (std::uint32_t const v : facets[edge.facets[k]].vertices)
                if (v != edge.vertices[0] && v != edge.vertices[1]) {
                    Vector3 const to = vertices[v] - from;
                    made.inwards[k] = unit(to - dot(to, along) * along);
                }
        made.stands = stand(made.inwards.data(), count);
        edges_.push_back(made);
    }
}

void MeshFeatures::find_corners(shape::TriangleMesh const& mesh)
{
    auto const& vertices = mesh.vertices();
    directions_first_.assign(vertices.size() + 1, 0);
    for (shape::MeshEdge const& edge : mesh.edges())
        for (std::uint32_t const v : edge.vertices)
            ++directions_first_[v + 1];
    for (std::size_t v = 0; v < vertices.size(); ++v)
        directions_first_[v + 1] += directions_first_[v];
    directions_.resize(directions_first_.back());
    auto next = directions_first_;
    for (shape::MeshEdge const& edge : mesh.edges()) {
        auto const [a, b] = edge.vertices;
        Vector3 const along = unit(vertices[b] - vertices[a]);
        directions_[next[a]++] = along;
        directions_[next[b]++] = -along;
    }
    for (std::size_t v = 0; v < vertices.size(); ++v)
        corners_.push_back(stand(directions_.data() + directions_first_[v],
                                 directions_first_[v + 1] - directions_first_[v]));
}

} // namespace demens::dem
