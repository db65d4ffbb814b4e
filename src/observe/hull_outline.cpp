#include "demens/observe/hull_outline.hpp"

#include <algorithm>
#include <cmath>

namespace demens::observe {
namespace {

double turn(Vector3 const& a, Vector3 const& b, Vector3 const& c)
{
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

//! The convex hull of points seen along y, counter-clockwise (Andrew 1979).
std::vector<Vector3> around(std::vector<Vector3> points)
{
    std::sort(points.begin(), points.end(),
              [](Vector3 const& a, Vector3 const& b) { return a.x != b.x ? a.x < b.x : a.z < b.z; });
    std::vector<Vector3> hull;
    auto const pass = [&](auto begin, auto end) {
        std::size_t const first = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    pass(points.begin(), points.end());
    pass(points.rbegin(), points.rend());
    return hull;
}

} // namespace

HullOutline::HullOutline(dem::HullPlace const& hull) : HullOutline(hull, demens::Rotation{}) {}

HullOutline::HullOutline(dem::HullPlace const& hull, demens::Rotation const& axes)
    : rounding_(hull.rounding()), core_(&hull.shape->hull->core), shape_(hull.shape)
{
    Vector3 const centre = axes(hull.position);
    place_ = {centre.x, centre.y, centre.z, hull.radius * hull.shape->reach()};
    for (Vector3 const& vertex : core_->vertices())
        vertices_.push_back(axes(hull(vertex)));
    for (grain::HullFace const& face : core_->faces())
        normals_.push_back(axes(hull.orientation(face.normal)));
    silhouette_ = around(vertices_);
}

std::optional<double> HullOutline::top(double x, double y) const
{
    // The highest of the surface's parts over the place: balls at corners, cylinders along edges, faces.
    double const r = rounding_;
    std::optional<double> highest;
    auto const add = [&](double z) { highest = highest ? std::max(*highest, z) : z; };
    for (Vector3 const& p : vertices_)
        if (double const rest = r * r - (x - p.x) * (x - p.x) - (y - p.y) * (y - p.y); rest >= 0)
            add(p.z + std::sqrt(rest));
    for (grain::HullEdge const& edge : core_->edges()) {
        Vector3 const from = vertices_[edge.vertices[0]], along = vertices_[edge.vertices[1]] - from;
        double const length = norm(along);
        Vector3 const e = along / length;
        // Where the line along z through the place is at the distance r from the edge.
        double const a = 1 - e.z * e.z;
        if (a < 1e-12)
            continue;
        Vector3 const w{x - from.x, y - from.y, 0};
        double const we = dot(w, e), b = -we * e.z, c = norm_squared(w) - we * we - r * r;
        double const root = b * b - a * c;
        if (root < 0)
            continue;
        double const z = (-b + std::sqrt(root)) / a, at = we + z * e.z;
        if (at >= 0 && at <= length)
            add(from.z + z);
    }
    for (std::size_t f = 0; f < normals_.size(); ++f) {
        Vector3 const& n = normals_[f];
        if (n.z <= 1e-12)
            continue;
        auto const corners = core_->corners(core_->faces()[f]);
        Vector3 const foot = vertices_[corners[0]] + r * n;
        double const z = foot.z - ((x - foot.x) * n.x + (y - foot.y) * n.y) / n.z;
        Vector3 const p = Vector3{x, y, z} - r * n;
        bool inside = true;
        for (std::size_t k = 0; k < corners.size() && inside; ++k) {
            Vector3 const &a = vertices_[corners[k]], &b = vertices_[corners[(k + 1) % corners.size()]];
            inside = dot(cross(b - a, p - a), n) >= 0;
        }
        if (inside)
            add(z);
    }
    return highest;
}

template <double Vector3::*u, double Vector3::*v>
std::optional<std::pair<double, double>> HullOutline::chord(double at) const
{
    double const r = rounding_;
    std::optional<std::pair<double, double>> found;
    auto const add = [&](double lower, double upper) {
        found = found ? std::pair{std::min(found->first, lower), std::max(found->second, upper)}
                      : std::pair{lower, upper};
    };
    for (std::size_t k = 0; k < silhouette_.size(); ++k) {
        Vector3 const &a = silhouette_[k], &b = silhouette_[(k + 1) % silhouette_.size()];
        if (double const rest = r * r - (at - a.*u) * (at - a.*u); rest >= 0)
            add(a.*v - std::sqrt(rest), a.*v + std::sqrt(rest));
        // The side, further outwards by the rounding.
        double const du = b.*u - a.*u, dv = b.*v - a.*v, length = std::hypot(du, dv);
        if (length == 0)
            continue;
        for (double const side : {-1.0, 1.0}) { // one of them lies within
            double const from = a.*u + side * r * dv / length, share = du != 0 ? (at - from) / du : -1;
            if (share >= 0 && share <= 1) {
                double const to = a.*v - side * r * du / length + share * dv;
                add(to, to);
            }
        }
    }
    return found;
}

std::pair<double, double> HullOutline::across() const
{
    auto const [left, right] = std::minmax_element(
        silhouette_.begin(), silhouette_.end(), [](Vector3 const& a, Vector3 const& b) { return a.x < b.x; });
    return {left->x - rounding_, right->x + rounding_};
}

std::pair<double, double> HullOutline::upwards() const
{
    auto const [bottom, top] = std::minmax_element(
        silhouette_.begin(), silhouette_.end(), [](Vector3 const& a, Vector3 const& b) { return a.z < b.z; });
    return {bottom->z - rounding_, top->z + rounding_};
}

std::optional<double> HullOutline::top(double x) const
{
    auto const found = chord<&Vector3::x, &Vector3::z>(x);
    return found ? std::optional(found->second) : std::nullopt;
}

std::optional<std::pair<double, double>> HullOutline::across(double z) const
{
    return chord<&Vector3::z, &Vector3::x>(z);
}

} // namespace demens::observe
