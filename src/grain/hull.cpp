#include "demens/grain/hull.hpp"

#include "demens/base/contract.hpp"
#include "demens/grain/mesh_mass.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace demens::grain {
namespace {

NumberLists lists_of(std::vector<std::vector<std::uint16_t>> const& lists)
{
    NumberLists result;
    result.first.push_back(0);
    for (auto const& list : lists) {
        result.numbers.insert(result.numbers.end(), list.begin(), list.end());
        result.first.push_back(static_cast<std::uint16_t>(result.numbers.size()));
    }
    return result;
}

} // namespace

Hull::Hull(std::vector<Vector3> vertices, std::vector<std::vector<std::uint16_t>> const& faces)
    : vertices_(std::move(vertices))
{
    for (auto const& loop : faces) {
        faces_.push_back(
            {{}, 0, static_cast<std::uint16_t>(loops_.size()), static_cast<std::uint16_t>(loop.size())});
        loops_.insert(loops_.end(), loop.begin(), loop.end());
    }
    find_planes();
    find_edges();
}

void Hull::find_planes()
{
    for (HullFace& face : faces_) {
        auto const loop = corners(face);
        Vector3 const& origin = vertices_[loop[0]];
        Vector3 area; // doubled
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
            area += cross(vertices_[loop[k]] - origin, vertices_[loop[k + 1]] - origin);
        face.normal = area / norm(area);
        face.offset = dot(face.normal, origin);
        for (auto const v : loop)
            face.offset = std::max(face.offset, dot(face.normal, vertices_[v]));
    }
}

void Hull::find_edges()
{
    std::map<std::array<std::uint16_t, 2>, std::array<std::uint16_t, 2>> faces_of;
    std::vector<std::vector<std::uint16_t>> around(vertices_.size()), faces_around(vertices_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        auto const loop = corners(faces_[f]);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            std::uint16_t const from = loop[k], to = loop[(k + 1) % loop.size()];
            faces_around[from].push_back(static_cast<std::uint16_t>(f));
            around[from].push_back(to);
            faces_of[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1] =
                static_cast<std::uint16_t>(f);
        }
    }
    for (auto const& [vertices, faces] : faces_of)
        edges_.push_back({vertices, faces});
    DEMENS_EXPECT(faces_.empty() || vertices_.size() + faces_.size() == edges_.size() + 2,
                  "the faces close the hull");
    for (HullFace const& face : faces_) {
        auto const loop = corners(face);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            std::uint16_t const from = loop[k], to = loop[(k + 1) % loop.size()];
            auto const edge = faces_of.find({std::min(from, to), std::max(from, to)});
            loop_edges_.push_back(static_cast<std::uint16_t>(std::distance(faces_of.begin(), edge)));
        }
    }
    neighbours_ = lists_of(around);
    faces_of_vertices_ = lists_of(faces_around);
}

Hull Hull::seen_from(Vector3 const& centre, Quaternion const& axes) const
{
    Hull result = *this;
    for (Vector3& v : result.vertices_)
        v = axes.inverse(v - centre);
    result.find_planes();
    return result;
}

Hull Hull::scaled(double factor) const
{
    DEMENS_EXPECT(factor > 0, "a hull is not mirrored");
    Hull result = *this;
    for (Vector3& v : result.vertices_)
        v *= factor;
    result.find_planes(); // so that a hull that is made of these vertices again is the same to the bit
    return result;
}

Hull flat_hull(std::vector<Vector3> corners)
{
    std::vector<std::uint16_t> front(corners.size());
    std::iota(front.begin(), front.end(), std::uint16_t{0});
    std::vector<std::uint16_t> const back(front.rbegin(), front.rend());
    return Hull(std::move(corners), {front, back});
}

Hull point_hull()
{
    return Hull({Vector3{}}, {});
}

VolumeMoments volume_moments(Hull const& hull)
{
    Vector3 middle;
    for (Vector3 const& v : hull.vertices())
        middle += v / static_cast<double>(hull.vertices().size());
    VolumeMoments moments;
    for (HullFace const& face : hull.faces()) {
        auto const loop = hull.corners(face);
        auto const corner = [&](std::size_t k) { return hull.vertices()[loop[k]] - middle; };
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
            moments += of_tetrahedron(corner(0), corner(k), corner(k + 1));
    }
    return moments.shifted(middle);
}

double surface_area(Hull const& hull)
{
    double area = 0;
    for (HullFace const& face : hull.faces()) {
        auto const loop = hull.corners(face);
        Vector3 const& origin = hull.vertices()[loop[0]];
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
            area += 0.5 * dot(face.normal, cross(hull.vertices()[loop[k]] - origin,
                                                 hull.vertices()[loop[k + 1]] - origin));
    }
    return area;
}

} // namespace demens::grain
