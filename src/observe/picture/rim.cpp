#include "demens/observe/picture/rim.hpp"

#include "src/observe/picture/sample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::observe {
namespace {

constexpr int directions = 720;
constexpr double reaches[] = {
    0.06, 0.3};               //!< how far off the circle the rim is looked for, in radii: near, then wide
constexpr double step = 0.25; //!< along a radius [pixels]
constexpr double beyond = 2;  //!< pixels that must be seen on both sides of the rim
constexpr double least_change = 0.25; //!< of the contrast of bed and light, that is an edge
constexpr double least_arc_deg = 45;
constexpr double known_within =
    0.25; //!< standard error of the circle's middle and radius that is enough [pixels]
constexpr double dark_share = 0.97;     //!< of a circumference that no bed makes dark
constexpr double rim_share = 0.1;       //!< by which the dark part of a circumference grows towards a rim
constexpr double place_tolerance = 0.5; //!< [pixels]
//! A drum's rim has a width of its own. A circle that is a pixel too wide moves a surface that passes the
//! axis at half the radius by half a pixel, and one that passes it closer by less. [pixels]
constexpr double size_tolerance = 1;

//! A place of the rim: direction from the circle's middle and distance from the circle.
struct RimPoint
{
    double cosine, sine, off;
};

//! What lies inside of an edge, as seen from outside.
enum class Inside
{
    darker, //!< bed or rim before a light surrounding
    lighter //!< light in a dark surrounding
};

struct Edge
{
    double off; //!< from the circle, outwards [pixels]
    Inside inside;
};

//! Along a radius, from as far as the window and the picture go inwards: the first change by a quarter of the
//! contrast, at the middle between outside and where the change is over. So it is where darkness of rim and
//! bed differ, too.
std::optional<Edge> edge_along(GreyImage const& image, Circle const& near, RimPoint const& direction,
                               double contrast, double window)
{
    std::vector<double> along; // from inside outwards
    for (double off = -window; off <= window; off += step) {
        double const x = near.x + (near.radius + off) * direction.cosine,
                     y = near.y + (near.radius + off) * direction.sine;
        if (x < 0.5 || y < 0.5 || x > image.columns - 0.5 || y > image.rows - 0.5)
            break;
        along.push_back(image.between(x, y));
    }
    std::size_t const margin = static_cast<std::size_t>(beyond / step);
    if (along.size() < 3 * margin)
        return std::nullopt;
    double outside = 0;
    for (std::size_t k = along.size() - margin; k < along.size(); ++k)
        outside += along[k] / static_cast<double>(margin);
    std::size_t k = along.size() - margin;
    while (k > margin && std::abs(along[k] - outside) < least_change * contrast)
        --k;
    if (k == margin)
        return std::nullopt;
    double const sense = along[k] > outside ? 1 : -1;
    double most = along[k];
    for (std::size_t inner = k, since = 0; inner-- > 0 && since < margin; ++since)
        if (sense * (along[inner] - most) > 0)
            most = along[inner], since = 0;
    double const middle = 0.5 * (outside + most);
    std::size_t at = std::min(along.size() - 2, k + margin);
    while (at > 0 && sense * (along[at] - middle) < 0)
        --at;
    double const share = (along[at] - middle) / (along[at] - along[at + 1]);
    return Edge{-window + step * (static_cast<double>(at) + share),
                sense > 0 ? Inside::darker : Inside::lighter};
}

//! Places of the rim, of that kind of edge which more directions show.
std::vector<RimPoint> rim_points(GreyImage const& image, Circle const& near, double contrast, double window)
{
    std::vector<RimPoint> darker, lighter;
    for (int k = 0; k < directions; ++k) {
        double const angle = 2 * std::numbers::pi * k / directions;
        RimPoint point{std::cos(angle), std::sin(angle), 0};
        if (auto const edge = edge_along(image, near, point, contrast, window)) {
            point.off = edge->off;
            (edge->inside == Inside::darker ? darker : lighter).push_back(point);
        }
    }
    return darker.size() >= lighter.size() ? darker : lighter;
}

//! A circle through places of the rim, and how well it is known.
struct Fit
{
    Circle circle;
    double standard_error; //!< the largest of those of middle and radius [pixels]
};

//! Least squares for off = dr + dx cos + dy sin, by the inverse of the normal equations.
Fit fitted(std::vector<RimPoint> const& points, Circle const& near)
{
    double n = 0, c = 0, s = 0, cc = 0, cs = 0, ss = 0, r = 0, rc = 0, rs = 0;
    for (auto const& p : points) {
        n += 1, c += p.cosine, s += p.sine;
        cc += p.cosine * p.cosine, cs += p.cosine * p.sine, ss += p.sine * p.sine;
        r += p.off, rc += p.off * p.cosine, rs += p.off * p.sine;
    }
    double const a = cc * ss - cs * cs, b = cs * s - c * ss, d = c * cs - cc * s; // cofactors
    double const e = n * ss - s * s, f = c * s - n * cs, g = n * cc - c * c;
    double const determinant = n * a + c * b + s * d;
    double const dr = (a * r + b * rc + d * rs) / determinant, dx = (b * r + e * rc + f * rs) / determinant,
                 dy = (d * r + f * rc + g * rs) / determinant;
    double squares = 0;
    for (auto const& p : points)
        squares += std::pow(p.off - dr - dx * p.cosine - dy * p.sine, 2);
    // Neighbouring directions see the same pixels: about a pixel of the circumference is one place.
    double const places = std::min(n, n / directions * 2 * std::numbers::pi * near.radius);
    double const variance = squares / n * (n / places) * std::max({a, e, g}) / determinant;
    return {{near.x + dx, near.y + dy, near.radius + dr}, std::sqrt(std::max(0.0, variance))};
}

double distance(RimPoint const& p, Circle const& circle, Circle const& near)
{
    return std::abs(p.off - (circle.radius - near.radius) - (circle.x - near.x) * p.cosine -
                    (circle.y - near.y) * p.sine);
}

std::optional<SeenRim> find_within(GreyImage const& image, Circle const& near, double contrast, double window)
{
    auto points = rim_points(image, near, contrast, window);
    double const arc = 360.0 / directions;
    Fit fit{near, 0};
    // The surface meets the rim, and dust lies on it: what is far from the circle is left out.
    for (int round = 0; round < 6; ++round) {
        if (arc * static_cast<double>(points.size()) < least_arc_deg)
            return std::nullopt;
        fit = fitted(points, near);
        std::vector<double> distances;
        for (auto const& p : points)
            distances.push_back(distance(p, fit.circle, near));
        double const most = std::max(0.25, 4 * quantile_of(std::move(distances), 0.5));
        std::erase_if(points, [&](auto const& p) { return distance(p, fit.circle, near) > most; });
    }
    if (!(fit.standard_error <= known_within))
        return std::nullopt;
    return SeenRim{fit.circle, arc * static_cast<double>(points.size())};
}

} // namespace

std::optional<SeenRim> find_rim(GreyImage const& image, Circle const& near, double contrast)
{
    for (double const reach : reaches)
        if (auto const rim = find_within(image, near, contrast, std::max(4.0, reach * near.radius)))
            return rim;
    return std::nullopt;
}

void require_circle(GreyImage const& image, Circle const& circle, double contrast)
{
    auto const seen = find_rim(image, circle, contrast);
    if (!seen)
        throw InputError(
            fmt::format("no rim is seen near the circle about ({:.6g}, {:.6g}) with a radius of {:.6g} "
                        "pixels, so that it cannot "
                        "be checked; give the drum's inner circle, or say that yours is to be trusted",
                        circle.x, circle.y, circle.radius));
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
    auto const dark_at = [&](double radius) {
        int dark = 0;
        for (int k = 0; k < directions; ++k) {
            double const angle = 2 * std::numbers::pi * k / directions;
            dark +=
                cut.excess.between(inner.x + radius * std::cos(angle), inner.y + radius * std::sin(angle)) > 0
                    ? 1
                    : 0;
        }
        return static_cast<double>(dark) / directions;
    };
    // A bed's share of the circumference hardly changes over a few pixels, a rim's does.
    double const outer = dark_at(inner.radius), further_in = dark_at(0.97 * inner.radius - 1);
    if (outer > dark_share || outer - further_in > rim_share)
        throw InputError(
            fmt::format("the picture is dark along {:.0f} % of the circumference at {:.4g} pixels from the "
                        "middle of its circle, where the rim should be over: it reaches further in than the "
                        "outermost part that is not looked at; widen that part (rim)",
                        100 * outer, inner.radius));
}

} // namespace demens::observe
