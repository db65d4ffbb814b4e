#include "demens/base/error.hpp"
#include "demens/grain/hull.hpp"
#include "demens/shape/triangle_tree.hpp"
#include "src/grain/qhull.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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

//! Without those that lie at the place of an earlier one.
std::vector<Vector3> distinct(std::vector<Vector3> const& points, double little)
{
    std::vector<Vector3> kept;
    for (Vector3 const& p : points)
        if (std::none_of(kept.begin(), kept.end(), [&](Vector3 const& k) { return norm(k - p) <= little; }))
            kept.push_back(p);
    return kept;
}

//! The vertices in a plane, counter-clockwise seen from outside, from the smallest number on.
Loop loop_in(QhullResult::Plane const& plane, std::vector<Vector3> const& vertices, double little)
{
    Loop loop;
    Vector3 middle;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (dot(plane.normal, vertices[v]) >= plane.offset - little) {
            loop.push_back(static_cast<std::uint16_t>(v));
            middle += vertices[v];
        }
    if (loop.size() < 3)
        return {};
    middle = middle / static_cast<double>(loop.size());
    Vector3 const u = any_normal_to(plane.normal), w = cross(plane.normal, u);
    auto const angle = [&](std::uint16_t v) {
        return std::atan2(dot(vertices[v] - middle, w), dot(vertices[v] - middle, u));
    };
    std::sort(loop.begin(), loop.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    return loop;
}

//! A loop for each plane that is not a part of another one's; sorted.
std::vector<Loop> loops_of(std::vector<QhullResult::Plane> const& planes,
                           std::vector<Vector3> const& vertices, double little)
{
    std::set<Loop> found;
    for (auto const& plane : planes)
        if (Loop loop = loop_in(plane, vertices, little); !loop.empty())
            found.insert(std::move(loop));
    std::vector<Loop> loops;
    auto const holds = [](Loop const& all, Loop const& some) {
        return all.size() > some.size() && std::all_of(some.begin(), some.end(), [&](auto v) {
                   return std::find(all.begin(), all.end(), v) != all.end();
               });
    };
    for (Loop const& loop : found)
        if (std::none_of(found.begin(), found.end(), [&](Loop const& other) { return holds(other, loop); }))
            loops.push_back(loop);
    return loops;
}

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
    if (found.corners.size() > 20 * most_vertices)
        refuse_size(found.corners.size());
    std::vector<Vector3> corners;
    for (auto const k : found.corners)
        corners.push_back(centred[k]);
    // Where a surface is so finely bent that planes within the tolerance share corners, a smaller one is
    // right.
    for (double const tolerance : {same_place, 1e-3 * same_place, 1e-6 * same_place}) {
        double const little = tolerance * size;
        std::vector<Vector3> vertices = distinct(corners, little);
        std::vector<Loop> loops = loops_of(found.planes, vertices, little);
        drop_false_corners(vertices, loops);
        if (!is_closed(vertices.size(), loops))
            continue;
        if (vertices.size() > most_vertices)
            refuse_size(vertices.size());
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
