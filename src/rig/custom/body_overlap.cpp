#include "src/rig/custom/body_overlap.hpp"

#include "demens/base/error.hpp"
#include "demens/grain/contact/core_gap.hpp"
#include "src/rig/custom/geometry.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

bool is_hull(Body const& body)
{
    return body.shape && body.shape->is_hull();
}

//! A convex part of a grain: the core of a hull, or the middle of a sphere.
struct Part
{
    grain::Hull const* core;
    grain::CorePose pose;
    double rounding, radius; //!< around the core; to compare with [m]
};

std::vector<Part> parts_of(Body const& body, grain::Hull const& point)
{
    std::vector<Part> parts;
    if (is_hull(body))
        return {{&body.shape->hull->core,
                 {body.place, body.orientation.rotation(), body.radius},
                 body.radius * body.shape->hull->rounding,
                 body.radius}};
    for_each_ball(body, [&](Vector3 const& centre, double radius, double) {
        parts.push_back({&point, {centre}, radius, radius});
    });
    return parts;
}

double gap_between(Part const& a, Part const& b)
{
    grain::CorePair const pair(grain::CoreView(*a.core), a.pose, grain::CoreView(*b.core), b.pose);
    grain::PairMemory nothing;
    return grain::core_gap(pair, a.rounding + b.rounding, nothing).gap;
}

BodyOverlap worse(BodyOverlap const& a, BodyOverlap const& b)
{
    return b.relative() > a.relative() ? b : a;
}

//! Extent of a body along the axis on which bodies are sorted.
struct Interval
{
    double from, to;
    Body const* body;
};

} // namespace

void for_each_ball(Body const& body, std::function<void(Vector3 const&, double, double)> const& visit)
{
    if (!body.shape)
        return visit(body.place, body.radius, body.radius);
    for (auto const& [place, radius] : body.shape->balls) {
        double const size = body.radius * radius;
        visit(body.place + body.orientation(body.radius * place), size, is_hull(body) ? body.radius : size);
    }
}

BodyOverlap overlap_of(Body const& a, Body const& b)
{
    BodyOverlap worst{a.reach() + b.reach() - norm(a.place - b.place), std::min(a.radius, b.radius)};
    if ((!a.shape && !b.shape) || worst.depth <= 0)
        return worst;
    worst.depth = -worst.depth; // they are near, and touch where the following says
    auto const point = grain::point_hull();
    auto const of_b = parts_of(b, point);
    for (Part const& one : parts_of(a, point))
        for (Part const& other : of_b) {
            double const radius = std::min(one.radius, other.radius);
            bool const balls = one.core == &point && other.core == &point;
            double const gap = balls ? norm(one.pose.place - other.pose.place) : gap_between(one, other);
            worst = worse(worst, {one.rounding + other.rounding - gap, radius});
        }
    return worst;
}

void check_overlaps(std::vector<Body> const& bodies, std::size_t old, double limit)
{
    std::vector<Interval> intervals;
    for (auto const& body : bodies)
        intervals.push_back({body.place.x - body.reach(), body.place.x + body.reach(), &body});
    std::sort(intervals.begin(), intervals.end(), [](auto const& a, auto const& b) {
        return a.from != b.from ? a.from < b.from : a.body < b.body;
    });
    auto const is_old = [&](Body const* body) {
        return static_cast<std::size_t>(body - bodies.data()) < old;
    };
    BodyOverlap worst{limit, 1};
    Body const *first = nullptr, *second = nullptr;
    for (std::size_t i = 0; i < intervals.size(); ++i)
        for (std::size_t j = i + 1; j < intervals.size() && intervals[j].from < intervals[i].to; ++j) {
            auto const &a = *intervals[i].body, &b = *intervals[j].body;
            if (is_old(&a) && is_old(&b))
                continue;
            BodyOverlap const overlap = overlap_of(a, b);
            if (overlap.relative() > worst.relative()) {
                worst = overlap;
                first = std::min(&a, &b);
                second = std::max(&a, &b);
            }
        }
    if (first)
        throw InputError(fmt::format(
            "two particles overlap by {:.4g} mm, {:.3g} of the smaller radius, where initial_overlap = "
            "{:.3g}: {} "
            "({}) and {} ({})",
            1e3 * worst.depth, worst.relative(), limit, first->origin, in_millimetres(first->place),
            second->origin, in_millimetres(second->place)));
}

} // namespace demens::rig::custom
