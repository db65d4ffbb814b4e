#include "demens/picture_file/scene.hpp"

#include "demens/base/extent.hpp"
#include "demens/observe/hull_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace demens::picture_file {
namespace {

using Colour = std::array<double, 3>; //!< 0 to 255

constexpr Colour paper = {255, 255, 255}, ink = {60, 71, 84};
constexpr Colour front = {226, 197, 150}, back = {122, 101, 76}; //!< of particles, by their depth
constexpr int oversampling = 2;                                  //!< in both directions, against jagged edges
constexpr double margin = 0.04;                                  //!< of the wider extent

Colour mixed(Colour const& a, Colour const& b, double share)
{
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

//! Extents of what is there: the particles, of walls where there are none [m].
std::array<Extent, 3> extents_of(observe::Snapshot const& snapshot)
{
    std::array<Extent, 3> along;
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        std::array<double, 3> const place = {snapshot.x[i], snapshot.y[i], snapshot.z[i]};
        if (std::all_of(place.begin(), place.end(), [](double at) { return std::isfinite(at); }))
            for (std::size_t axis = 0; axis < 3; ++axis)
                along[axis].include(place[axis], snapshot.radius[i]);
    }
    if (along[0].width() > 0)
        return along;
    for (auto const* outlines : {&snapshot.walls, &snapshot.wall_lines})
        for (auto const& outline : *outlines)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                along[axis].include(outline[axis]);
                along[axis].include(outline[axis + 3]);
            }
    return along;
}

class Canvas
{
  public:
    Canvas(std::array<Extent, 3> const& along, int columns)
        : across_(along[0].width() >= along[1].width() ? 0 : 1), depth_(along[1 - across_])
    {
        double const room = margin * std::max({along[across_].width(), along[2].width(), 1e-12});
        left_ = along[across_].lower - room;
        top_ = along[2].upper + room;
        double const width = along[across_].width() + 2 * room, height = along[2].width() + 2 * room;
        pixel_ = std::max(width, height / 2) / (columns * oversampling);
        left_ -= 0.5 * (pixel_ * columns * oversampling - width); // a slender scene stands in the middle
        columns_ = columns * oversampling;
        rows_ = oversampling *
                std::clamp(static_cast<int>(std::ceil(height / pixel_ / oversampling)), 1, 2 * columns);
        colours_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), paper);
        nearest_.assign(colours_.size(), std::numeric_limits<double>::infinity());
    }

    void sphere(std::array<double, 3> const& place, double radius)
    {
        double const h = (place[across_] - left_) / pixel_, v = (top_ - place[2]) / pixel_,
                     r = std::max(radius / pixel_, 0.5);
        double const share = depth_.width() > 0 ? (place[1 - across_] - depth_.lower) / depth_.width() : 0;
        auto const colour = mixed(front, back, std::clamp(share, 0.0, 1.0));
        for (int row = first(v - r); row <= std::min(rows_ - 1, static_cast<int>(v + r)); ++row)
            for (int column = first(h - r); column <= std::min(columns_ - 1, static_cast<int>(h + r));
                 ++column) {
                double const x = (column + 0.5 - h) / r, y = (row + 0.5 - v) / r, square = x * x + y * y;
                if (square > 1)
                    continue;
                double const towards = std::sqrt(1 - square), depth = place[1 - across_] - towards * radius;
                auto const at = index(column, row);
                if (depth >= nearest_[at])
                    continue;
                nearest_[at] = depth;
                double const light = std::max(0.0, (-0.45 * x - 0.6 * y + 0.66 * towards));
                colours_[at] = mixed({0, 0, 0}, colour, 0.45 + 0.55 * light);
            }
    }

    //! A face that is flat, seen from its outer side.
    void triangle(Vector3 const& a, Vector3 const& b, Vector3 const& c)
    {
        Vector3 const across = seen(b) - seen(a), other = seen(c) - seen(a);
        Vector3 const n = cross(across, other);     // in pixels: right, down, into the picture
        double const sense = across_ == 0 ? 1 : -1; // x, z, y and y, z, x turn in different senses
        double const towards = -sense * n.z / norm(n);
        if (!(towards > 0))
            return;
        double const light = std::max(0.0, sense * (-0.45 * n.x - 0.6 * n.y) / norm(n) + 0.66 * towards);
        Vector3 const from = seen(a);
        // Its pixels.
        double const least_h = std::min({0.0, across.x, other.x}),
                     most_h = std::max({0.0, across.x, other.x});
        double const least_v = std::min({0.0, across.y, other.y}),
                     most_v = std::max({0.0, across.y, other.y});
        double const area = across.x * other.y - across.y * other.x;
        for (int row = first(from.y + least_v); row <= last(from.y + most_v, rows_); ++row)
            for (int column = first(from.x + least_h); column <= last(from.x + most_h, columns_); ++column) {
                double const x = column + 0.5 - from.x, y = row + 0.5 - from.y;
                double const u = (x * other.y - y * other.x) / area, v = (across.x * y - across.y * x) / area;
                if (u < 0 || v < 0 || u + v > 1)
                    continue;
                double const depth = pixel_ * (from.z + u * across.z + v * other.z);
                auto const at = index(column, row);
                if (depth >= nearest_[at])
                    continue;
                nearest_[at] = depth;
                double const share = depth_.width() > 0 ? (depth - depth_.lower) / depth_.width() : 0;
                colours_[at] =
                    mixed({0, 0, 0}, mixed(front, back, std::clamp(share, 0.0, 1.0)), 0.45 + 0.55 * light);
            }
    }

    void line(std::array<double, 6> const& ends)
    {
        double const h0 = (ends[across_] - left_) / pixel_, v0 = (top_ - ends[2]) / pixel_,
                     h1 = (ends[across_ + 3] - left_) / pixel_, v1 = (top_ - ends[5]) / pixel_;
        double const length = std::max(std::abs(h1 - h0), std::abs(v1 - v0));
        if (!std::isfinite(length) || length > 100.0 * columns_)
            return;
        for (int k = 0; k <= static_cast<int>(length); ++k) {
            double const share = length > 0 ? k / length : 0;
            dot(h0 + share * (h1 - h0), v0 + share * (v1 - v0));
        }
    }

    //! The edges of an outline that is a box, as they are seen.
    void box(std::array<double, 6> const& box)
    {
        auto corner = [&](bool right, bool up) {
            std::array<double, 3> place{};
            place[across_] = right ? box[across_ + 3] : box[across_];
            place[2] = up ? box[5] : box[2];
            return place;
        };
        auto const edge = [&](std::array<double, 3> const& a, std::array<double, 3> const& b) {
            line({a[0], a[1], a[2], b[0], b[1], b[2]});
        };
        edge(corner(false, false), corner(true, false));
        edge(corner(true, false), corner(true, true));
        edge(corner(true, true), corner(false, true));
        edge(corner(false, true), corner(false, false));
    }

    ColourImage image() const
    {
        ColourImage image{columns_ / oversampling, rows_ / oversampling, {}};
        for (int row = 0; row < image.rows; ++row)
            for (int column = 0; column < image.columns; ++column) {
                Colour sum = {0, 0, 0};
                for (int k = 0; k < oversampling * oversampling; ++k) {
                    auto const& part = colours_[index(column * oversampling + k % oversampling,
                                                      row * oversampling + k / oversampling)];
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += part[c] / (oversampling * oversampling);
                }
                image.pixels.push_back({level(sum[0]), level(sum[1]), level(sum[2])});
            }
        return image;
    }

  private:
    //! Where a place is [pixels]: from the left, from the top, into the picture.
    Vector3 seen(Vector3 const& place) const
    {
        std::array<double, 2> const flat = {place.x, place.y};
        return {(flat[across_] - left_) / pixel_, (top_ - place.z) / pixel_, flat[1 - across_] / pixel_};
    }
    static int first(double at) { return std::max(0, static_cast<int>(at)); }
    static int last(double at, int count) { return std::min(count - 1, static_cast<int>(at)); }
    static std::uint8_t level(double value)
    {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    void dot(double h, double v)
    {
        for (int down = 0; down < oversampling; ++down)
            for (int right = 0; right < oversampling; ++right)
                if (double const x = h + right, y = v + down; x >= 0 && y >= 0 && x < columns_ && y < rows_)
                    colours_[index(static_cast<int>(x), static_cast<int>(y))] = ink;
    }

    std::size_t across_;        //!< axis across the picture; the other of x and y leads into it
    Extent depth_;              //!< [m]
    double left_, top_, pixel_; //!< [m]
    int columns_, rows_;
    std::vector<Colour> colours_;
    std::vector<double> nearest_; //!< depth of what is seen [m]
};

} // namespace

ColourImage picture_of(observe::Snapshot const& snapshot, int columns)
{
    Canvas canvas(extents_of(snapshot), std::max(columns, 8));
    auto const hulls = observe::hull_surfaces(snapshot);
    std::set<std::int64_t> const drawn(hulls.body.begin(), hulls.body.end());
    auto const is_ball = [&](std::size_t i) {
        std::uint32_t const hull = snapshot.hull.empty() ? observe::Snapshot::no_hull : snapshot.hull[i];
        return hull != observe::Snapshot::within_a_hull && !drawn.contains(std::int64_t{hull} - 1);
    };
    for (std::size_t face = 0, begin = 0; face < hulls.ends.size();
         begin = static_cast<std::size_t>(hulls.ends[face++])) {
        auto const corner = [&](std::size_t k) {
            return hulls.corners[static_cast<std::size_t>(hulls.faces[k])];
        };
        for (std::size_t k = begin + 2; k < static_cast<std::size_t>(hulls.ends[face]); ++k)
            canvas.triangle(corner(begin), corner(k - 1), corner(k));
    }
    for (std::size_t i = 0; i < snapshot.x.size(); ++i)
        if (is_ball(i) && std::isfinite(snapshot.x[i]) && std::isfinite(snapshot.y[i]) &&
            std::isfinite(snapshot.z[i]))
            canvas.sphere({snapshot.x[i], snapshot.y[i], snapshot.z[i]}, snapshot.radius[i]);
    for (auto const& wall : snapshot.walls)
        canvas.box(wall);
    for (auto const& edge : snapshot.wall_lines)
        canvas.line(edge);
    return canvas.image();
}

} // namespace demens::picture_file
