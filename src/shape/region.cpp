#include "demens/shape/region.hpp"

#include <algorithm>
#include <numbers>

namespace demens::shape {
namespace {

Vector3 smallest(Vector3 const& a, Vector3 const& b)
{
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vector3 largest(Vector3 const& a, Vector3 const& b)
{
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

bool holds(BoxRegion const& box, Vector3 const& p, double r)
{
    return p.x - r >= box.lower.x && p.y - r >= box.lower.y && p.z - r >= box.lower.z &&
           p.x + r <= box.upper.x && p.y + r <= box.upper.y && p.z + r <= box.upper.z;
}

bool holds(CylinderRegion const& cylinder, Vector3 const& p, double r)
{
    Vector3 const axis = cylinder.to - cylinder.from;
    double const length = norm(axis);
    Vector3 const along = axis / length, relative = p - cylinder.from;
    double const height = dot(relative, along), distance = norm(relative - height * along);
    bool const in_hole = cylinder.inner_radius > 0 && distance - r < cylinder.inner_radius;
    return height - r >= 0 && height + r <= length && distance + r <= cylinder.radius && !in_hole;
}

bool holds(BallRegion const& ball, Vector3 const& p, double r)
{
    return norm(p - ball.centre) + r <= ball.radius;
}

double size(BoxRegion const& box)
{
    Vector3 const d = box.upper - box.lower;
    return std::max(0.0, d.x) * std::max(0.0, d.y) * std::max(0.0, d.z);
}

double size(CylinderRegion const& cylinder)
{
    double const outer = cylinder.radius, inner = cylinder.inner_radius;
    return std::numbers::pi * (outer * outer - inner * inner) * norm(cylinder.to - cylinder.from);
}

double size(BallRegion const& ball)
{
    return 4.0 / 3.0 * std::numbers::pi * ball.radius * ball.radius * ball.radius;
}

BoxRegion box_of(BoxRegion const& box)
{
    return box;
}

BoxRegion box_of(CylinderRegion const& cylinder)
{
    Vector3 const &a = cylinder.from, &b = cylinder.to;
    Vector3 const axis = (b - a) / norm(b - a);
    // A disc reaches as far along a direction as the sine of the angle between them allows.
    auto const reach = [&](double component) {
        return cylinder.radius * std::sqrt(std::max(0.0, 1 - component * component));
    };
    Vector3 const r{reach(axis.x), reach(axis.y), reach(axis.z)};
    return {smallest(a, b) - r, largest(a, b) + r};
}

BoxRegion box_of(BallRegion const& ball)
{
    Vector3 const r{ball.radius, ball.radius, ball.radius};
    return {ball.centre - r, ball.centre + r};
}

} // namespace

bool contains(Region const& region, Vector3 const& centre, double radius)
{
    return std::visit([&](auto const& shape) { return holds(shape, centre, radius); }, region);
}

double volume(Region const& region)
{
    return std::visit([](auto const& shape) { return size(shape); }, region);
}

BoxRegion bounds(Region const& region)
{
    return std::visit([](auto const& shape) { return box_of(shape); }, region);
}

BoxRegion hull(BoxRegion const& a, BoxRegion const& b)
{
    return {smallest(a.lower, b.lower), largest(a.upper, b.upper)};
}

} // namespace demens::shape
