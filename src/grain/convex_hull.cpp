#include "demens/base/error.hpp"
#include "demens/grain/hull.hpp"
#include "demens/shape/triangle_tree.hpp"
#include "src/grain/qhull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace demens::grain {
namespace {

using Loop = std::vector<std::uint16_t>;

//! Points this near to each other or to a plane, over the size, are one or in it.
constexpr double same_place = 1e-6;

struct Size
{
    Vector3 middle;
    double size = 0; //!< diagonal of the bounds [m]
};

Size size_of(std::span<Vector3 const> points)
{
    shape::Bounds bounds{points[0], points[0]};
    for (Vector3 const& p : points)
        bounds.include(p);
    return {0.5 * (bounds.lower + bounds.upper), norm(bounds.upper - bounds.lower)};
}

//! The point for which a measure is largest, and the measure.
template <class Measure>
std::pair<Vector3, double> farthest(std::span<Vector3 const> points, Measure&& measure)
{
    std::pair<Vector3, double> best{points[0], measure(points[0])};
    for (Vector3 const& p : points)
        if (double const value = measure(p); value > best.second)
            best = {p, value};
    return best;
}

//! \throws InputError where the points are all one, on a line or in a plane
void refuse_flat(std::span<Vector3 const> points, std::string const& origin)
{
    double const size = size_of(points).size, little = same_place * size;
    auto const refuse = [&](std::string const& where) {
        throw InputError(
            fmt::format("{}: all {} points {}: a hull needs a volume, so give at least one point "
                        "farther off",
                        origin, points.size(), where));
    };
    if (size == 0)
        refuse("are one");
    Vector3 const a = farthest(points, [&](Vector3 const& p) { return norm(p - points[0]); }).first;
    Vector3 const b = farthest(points, [&](Vector3 const& p) { return norm(p - a); }).first;
    Vector3 const along = (b - a) / norm(b - a);
    auto const [c, off_line] = farthest(points, [&](Vector3 const& p) { return norm(cross(p - a, along)); });
    if (off_line <= little)
        refuse(fmt::format("lie on a line, within {:.3g} m", off_line));
    Vector3 const across = cross(along, c - a), normal = across / norm(across);
    double const off_plane =
        farthest(points, [&](Vector3 const& p) { return std::abs(dot(p - a, normal)); }).second;
    if (off_plane <= little)
        refuse(fmt::format("lie in a plane, within {:.3g} m", off_plane));
}

//! Triangles with corners that are numbers of vertices, and what they are made of.
struct Surface
{
    std::vector<Vector3> vertices;
    std::vector<QhullResult::Triangle> triangles;
};

//! Corners as near to an earlier one as `little` become one with it, in the order of the points; triangles
//! that this leaves without an area are gone.
Surface joined(std::span<Vector3 const> points, std::vector<QhullResult::Triangle> const& triangles,
               double little)
{
    std::map<std::size_t, std::size_t> number; // of a point's vertex
    for (auto const& triangle : triangles)
        for (auto const c : triangle.corners)
            number[c] = 0;
    Surface surface;
    for (auto& [point, vertex] : number) {
        auto const& all = surface.vertices;
        auto const same = std::find_if(all.begin(), all.end(), [&, p = points[point]](Vector3 const& v) {
            return norm(v - p) <= little;
        });
        vertex = static_cast<std::size_t>(same - all.begin());
        if (same == all.end())
            surface.vertices.push_back(points[point]);
    }
    for (auto const& [c, normal] : triangles) {
        std::array<std::size_t, 3> const v = {number[c[0]], number[c[1]], number[c[2]]};
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
            surface.triangles.push_back({v, normal});
    }
    return surface;
}

//! Puts triangles together that lie in one plane, from the largest on.
class Merger
{
  public:
    Merger(Surface const& surface, double little)
        : surface_(surface), little_(little), face_of_(surface.triangles.size(), none)
    {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                triangle_at_[side(t, k)] = t;
    }

    std::vector<Loop> faces()
    {
        std::vector<std::size_t> order(surface_.triangles.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<double> areas;
        for (std::size_t const t : order)
            areas.push_back(area(t));
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return areas[a] > areas[b]; });
        std::vector<Loop> loops;
        for (std::size_t const seed : order) {
            if (face_of_[seed] != none)
                continue;
            std::vector<std::size_t> const members = grown(seed);
            if (Loop loop = border(members); !loop.empty()) {
                loops.push_back(std::move(loop));
                continue;
            }
            for (std::size_t const t : members) // not one piece: triangles of their own
                loops.push_back(border({t}));
        }
        for (Loop& loop : loops)
            std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        std::sort(loops.begin(), loops.end());
        return loops;
    }

  private:
    using Side = std::pair<std::size_t, std::size_t>;
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    Vector3 const& corner(std::size_t t, std::size_t k) const
    {
        return surface_.vertices[surface_.triangles[t].corners[k]];
    }
    Side side(std::size_t t, std::size_t k) const
    {
        auto const& c = surface_.triangles[t].corners;
        return {c[k], c[(k + 1) % 3]};
    }
    double area(std::size_t t) const
    {
        return norm(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
    }

    //! A triangle and all that hang together with it and lie in its plane.
    std::vector<std::size_t> grown(std::size_t seed)
    {
        Vector3 const& normal = surface_.triangles[seed].normal;
        auto const is_in_plane = [&](std::size_t t) {
            for (std::size_t k = 0; k < 3; ++k)
                if (std::abs(dot(normal, corner(t, k) - corner(seed, 0))) > little_)
                    return false;
            return true;
        };
        std::vector<std::size_t> members = {seed};
        face_of_[seed] = seed;
        for (std::size_t m = 0; m < members.size(); ++m)
            for (std::size_t k = 0; k < 3; ++k) {
                auto const [from, to] = side(members[m], k);
                auto const next = triangle_at_.find({to, from});
                if (next != triangle_at_.end() && face_of_[next->second] == none &&
                    is_in_plane(next->second)) {
                    face_of_[next->second] = seed;
                    members.push_back(next->second);
                }
            }
        return members;
    }

    //! The loop around triangles; empty where there are several.
    Loop border(std::vector<std::size_t> const& members) const
    {
        std::map<std::size_t, std::size_t> next;
        std::set<Side> sides;
        for (std::size_t const t : members)
            for (std::size_t k = 0; k < 3; ++k)
                sides.insert(side(t, k));
        std::size_t count = 0;
        for (auto const& [from, to] : sides)
            if (!sides.contains({to, from})) {
                next[from] = to;
                ++count;
            }
        Loop loop;
        if (next.empty() || next.size() != count)
            return loop;
        std::size_t at = next.begin()->first;
        do {
            loop.push_back(static_cast<std::uint16_t>(at));
            at = next[at];
        } while (at != next.begin()->first && loop.size() <= count);
        return loop.size() == count ? loop : Loop{};
    }

    Surface const& surface_;
    double little_;
    std::vector<std::size_t> face_of_; //!< the triangle that it was grown from
    std::map<Side, std::size_t> triangle_at_;
};

//! Takes out vertices that are corners of fewer than three faces: they lie within a face or an edge.
void drop_false_corners(std::vector<Vector3>& vertices, std::vector<Loop>& loops)
{
    std::vector<int> faces(vertices.size(), 0);
    for (Loop const& loop : loops)
        for (auto const v : loop)
            ++faces[v];
    std::vector<std::uint16_t> number(vertices.size());
    std::vector<Vector3> kept;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        number[v] = static_cast<std::uint16_t>(kept.size());
        if (faces[v] >= 3)
            kept.push_back(vertices[v]);
    }
    for (Loop& loop : loops) {
        std::erase_if(loop, [&](auto v) { return faces[v] < 3; });
        for (auto& v : loop)
            v = number[v];
    }
    vertices = std::move(kept);
}

//! Whether each edge has two faces, which pass it in opposite senses, and nothing is missing (Euler).
bool is_closed(std::size_t vertices, std::vector<Loop> const& loops)
{
    std::set<std::pair<std::uint16_t, std::uint16_t>> passed;
    std::size_t sides = 0;
    for (Loop const& loop : loops) {
        if (loop.size() < 3)
            return false;
        for (std::size_t k = 0; k < loop.size(); ++k, ++sides)
            passed.emplace(loop[k], loop[(k + 1) % loop.size()]);
    }
    bool const paired =
        passed.size() == sides && std::all_of(passed.begin(), passed.end(), [&](auto const& p) {
            return passed.contains({p.second, p.first});
        });
    return paired && vertices + loops.size() == sides / 2 + 2;
}

} // namespace

Hull convex_hull(std::span<Vector3 const> points, std::string const& origin)
{
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!std::isfinite(points[k].x + points[k].y + points[k].z))
            throw InputError(
                fmt::format("{}: point {} of {} is not a finite number", origin, k + 1, points.size()));
    if (points.size() < 4)
        throw InputError(
            fmt::format("{}: a hull needs at least four points, there are {}", origin, points.size()));
    refuse_flat(points, origin);
    auto const [middle, size] = size_of(points);
    std::vector<Vector3> centred(points.begin(), points.end());
    for (Vector3& p : centred)
        p -= middle;
    QhullResult const found = run_qhull(centred);
    if (!found.error.empty())
        throw InputError(fmt::format("{}: no hull was found around the {} points. Qhull says: {}", origin,
                                     points.size(), found.error));
    auto const refuse_size = [&](std::size_t count) {
        throw InputError(fmt::format("{}: the hull has {} corners, more than {}: give a coarser surface",
                                     origin, count, most_vertices));
    };
    if (found.triangles.size() > 40 * most_vertices)
        refuse_size(found.triangles.size() / 2);
    // What is joined may not close any more where points are near to each other: then less is.
    for (double const tolerance : {same_place, 1e-3 * same_place, 0.0}) {
        double const little = tolerance * size;
        Surface surface = joined(centred, found.triangles, little);
        std::vector<Vector3>& vertices = surface.vertices;
        std::vector<Loop> loops = Merger(surface, little).faces();
        drop_false_corners(vertices, loops);
        if (!is_closed(vertices.size(), loops))
            continue;
        if (vertices.size() > most_vertices)
            refuse_size(vertices.size());
        for (Loop const& loop : loops)
            if (loop.size() > most_face_corners)
                throw InputError(fmt::format("{}: a face of the hull has {} corners, more than {}: give a "
                                             "coarser surface",
                                             origin, loop.size(), most_face_corners));
        for (Vector3& v : vertices)
            v += middle;
        std::sort(loops.begin(), loops.end());
        return Hull(std::move(vertices), loops);
    }
    throw InputError(fmt::format("{}: no closed hull was found around the {} points: some lie too near to "
                                 "each other for their distances to be told from rounding",
                                 origin, points.size()));
}

} // namespace demens::grain
