#include "demens/observe/cut_plane.hpp"

#include <algorithm>

namespace demens::observe {
namespace {

struct Span
{
    double from, to;
};

//! Places along a direction, from a point on, that a box takes and that are within `half` of the point.
Span span_of(Vector3 const& from, Vector3 const& along, double half, Vector3 const& lower,
             Vector3 const& upper)
{
    Vector3 const middle = 0.5 * (lower + upper), reach = 0.5 * (upper - lower);
    double const at = dot(middle - from, along);
    double const room =
        std::abs(along.x) * reach.x + std::abs(along.y) * reach.y + std::abs(along.z) * reach.z;
    return {std::clamp(at - room, -half, half), std::clamp(at + room, -half, half)};
}

} // namespace

dem::Rectangle cut_to(dem::Rectangle const& rectangle, Vector3 const& lower, Vector3 const& upper)
{
    auto const u = span_of(rectangle.centre, rectangle.axis_u, rectangle.half_u, lower, upper),
               v = span_of(rectangle.centre, rectangle.axis_v, rectangle.half_v, lower, upper);
    auto cut = rectangle;
    cut.centre = rectangle.centre + 0.5 * (u.from + u.to) * rectangle.axis_u +
                 0.5 * (v.from + v.to) * rectangle.axis_v;
    cut.half_u = 0.5 * (u.to - u.from);
    cut.half_v = 0.5 * (v.to - v.from);
    return cut;
}

} // namespace demens::observe
