#include "demens/observe/picture/rim.hpp"

#include "src/observe/picture/sample.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::observe {
namespace {

constexpr int directions = 720;
constexpr double reach = 0.06;          //!< how far off the circle the rim is looked for, in radii
constexpr double step = 0.25;           //!< along a radius [pixels]
constexpr double beyond = 2;            //!< pixels that must be seen on both sides of the rim
constexpr double least_arc_deg = 120;   //!< with less of the rim a circle is not known well
constexpr double place_tolerance = 0.5; //!< [pixels]
//! A drum's rim has a width of its own. A circle that is a pixel too wide moves a surface that passes the
//! axis at half the radius by half a pixel, and one that passes it closer by less. [pixels]
constexpr double size_tolerance = 1;

//! A place of the rim: direction from the circle's middle and distance from the circle.
struct RimPoint
{
    double cosine, sine, off;
};

//! Along a radius from inside outwards: where darkness passes the level for the last time to light, or, once
//! `to_dark`, for the only time to dark; none where this is not so.
std::optional<double> edge_along(GreyImage const& image, Circle const& near, double cosine, double sine,
                                 double level, bool to_dark)
{
    double const window = std::max(4.0, reach * near.radius);
    std::optional<double> edge;
    double last = 0, end = -window;
    bool has_last = false;
    for (double off = -window; off <= window; off += step) {
        double const x = near.x + (near.radius + off) * cosine, y = near.y + (near.radius + off) * sine;
        if (x < 0.5 || y < 0.5 || x > image.columns - 0.5 || y > image.rows - 0.5)
            break;
        double const now = image.between(x, y) - level;
        if (has_last && (last > 0) != (now > 0)) {
            if ((now > 0) == to_dark)
                edge = off - step * now / (now - last);
            else
                edge.reset();
        }
        last = now, has_last = true, end = off;
    }
    bool const is_whole = edge && end - *edge >= beyond && *edge + window >= beyond;
    return is_whole ? edge : std::nullopt;
}

std::vector<RimPoint> rim_points(GreyImage const& image, Circle const& near, double level, bool to_dark)
{
    std::vector<RimPoint> points;
    for (int k = 0; k < directions; ++k) {
        double const angle = 2 * std::numbers::pi * k / directions, c = std::cos(angle), s = std::sin(angle);
        if (auto const off = edge_along(image, near, c, s, level, to_dark))
            points.push_back({c, s, *off});
    }
    return points;
}

//! Least squares for off = dr + dx cos + dy sin, by Cramer's rule.
Circle fitted(std::vector<RimPoint> const& points, Circle const& near)
{
    double n = 0, c = 0, s = 0, cc = 0, cs = 0, ss = 0, r = 0, rc = 0, rs = 0;
    for (auto const& p : points) {
        n += 1, c += p.cosine, s += p.sine;
        cc += p.cosine * p.cosine, cs += p.cosine * p.sine, ss += p.sine * p.sine;
        r += p.off, rc += p.off * p.cosine, rs += p.off * p.sine;
    }
    double const determinant = n * (cc * ss - cs * cs) - c * (c * ss - cs * s) + s * (c * cs - cc * s);
    double const dr =
        (r * (cc * ss - cs * cs) - c * (rc * ss - cs * rs) + s * (rc * cs - cc * rs)) / determinant;
    double const dx = (n * (rc * ss - cs * rs) - r * (c * ss - cs * s) + s * (c * rs - rc * s)) / determinant;
    double const dy = (n * (cc * rs - rc * cs) - c * (c * rs - rc * s) + r * (c * cs - cc * s)) / determinant;
    return {near.x + dx, near.y + dy, near.radius + dr};
}

double distance(RimPoint const& p, Circle const& circle, Circle const& near)
{
    return std::abs(p.off - (circle.radius - near.radius) - (circle.x - near.x) * p.cosine -
                    (circle.y - near.y) * p.sine);
}

} // namespace

std::optional<SeenRim> find_rim(GreyImage const& image, Circle const& near, double level)
{
    auto points = rim_points(image, near, level, false);
    if (auto to_dark = rim_points(image, near, level, true); to_dark.size() > points.size())
        points = std::move(to_dark);
    double const arc = 360.0 / directions;
    Circle circle = near;
    // The surface meets the rim, and dust lies on it: what is far from the circle is left out.
    for (int round = 0; round < 5; ++round) {
        if (arc * static_cast<double>(points.size()) < least_arc_deg)
            return std::nullopt;
        circle = fitted(points, near);
        std::vector<double> distances;
        for (auto const& p : points)
            distances.push_back(distance(p, circle, near));
        double const most = std::max(0.25, 4 * quantile_of(std::move(distances), 0.5));
        std::erase_if(points, [&](auto const& p) { return distance(p, circle, near) > most; });
    }
    return SeenRim{circle, arc * static_cast<double>(points.size())};
}

void require_circle(GreyImage const& image, Circle const& circle, double level)
{
    auto const seen = find_rim(image, circle, level);
    if (!seen)
        return;
    double const off = std::hypot(seen->circle.x - circle.x, seen->circle.y - circle.y),
                 size = std::abs(seen->circle.radius - circle.radius);
    if (off > place_tolerance || size > size_tolerance)
        throw InputError(fmt::format("the circle about ({:.6g}, {:.6g}) with a radius of {:.6g} pixels is "
                                     "not the rim that the picture "
                                     "shows, along {:.0f} deg of it: about ({:.2f}, {:.2f}) with a radius of "
                                     "{:.2f}; give that circle, or "
                                     "say that yours is to be trusted",
                                     circle.x, circle.y, circle.radius, seen->arc_deg, seen->circle.x,
                                     seen->circle.y, seen->circle.radius));
}

void require_clear_rim(Cut const& cut, Circle const& inner)
{
    int dark = 0;
    for (int k = 0; k < directions; ++k) {
        double const angle = 2 * std::numbers::pi * k / directions;
        dark += cut.excess.between(inner.x + (inner.radius - 1) * std::cos(angle),
                                   inner.y + (inner.radius - 1) * std::sin(angle)) > 0
                    ? 1
                    : 0;
    }
    if (dark == directions)
        throw InputError(
            fmt::format("the picture is dark all around at {:.4g} pixels from the middle of its "
                        "circle, where the light should begin: the rim reaches further in than the "
                        "outermost part that is not looked at; widen that part (rim)",
                        inner.radius - 1));
}

} // namespace demens::observe
