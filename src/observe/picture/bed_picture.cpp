#include "demens/observe/picture/bed_picture.hpp"

#include "demens/observe/picture/rim.hpp"
#include "demens/observe/principal_line.hpp"
#include "demens/observe/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace demens::observe {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double explained = 0.9;     //!< share of a column's pixels that a surface must explain
constexpr double least_columns = 0.8; //!< share of a segment's columns that must have a surface
constexpr double falls_back_deg = 3;  //!< a bed that descends by more, as the drum turns, is seen mirrored

//! Row of the surface in a column, from the top, with the share of a pixel; NaN where there is none.
double surface_row(GreyImage const& excess, int column, int from, int end)
{
    auto const is_bed = [&](int row) { return excess.at(column, row) > 0; };
    int wrong = 0; // pixels that a surface above row `from` does not explain
    for (int row = from; row < end; ++row)
        wrong += is_bed(row) ? 0 : 1;
    int fewest = wrong, ties = 0;
    double sum = 0;
    bool is_at_end = true; // all bed, or all light
    for (int row = from + 1; row <= end; ++row) {
        wrong += is_bed(row - 1) ? 1 : -1;
        if (wrong < fewest || (wrong == fewest && !is_at_end && row < end)) {
            if (wrong < fewest)
                sum = 0, ties = 0;
            fewest = wrong, is_at_end = row == end;
            if (is_at_end)
                continue;
            double const above = static_cast<double>(excess.at(column, row - 1)),
                         below = static_cast<double>(excess.at(column, row));
            sum += row - 0.5 + above / (above - below); // above <= 0 < below
            ++ties;
        }
    }
    return is_at_end || fewest > (1 - explained) * (end - from) ? none : sum / ties;
}

//! Points of the surface, one a column of pixels where there is one [m].
std::vector<Point> surface_points(GreyImage const& excess, PictureFrame const& frame, Circle const& inner)
{
    std::vector<Point> points;
    for (int column = 0; column < frame.columns; ++column) {
        double const dx = column + 0.5 - inner.x, half = std::sqrt(inner.radius * inner.radius - dx * dx);
        if (!(half > 1))
            continue;
        int const from = std::max(0, static_cast<int>(std::ceil(inner.y - half - 0.5)));
        int const end = std::min(frame.rows, static_cast<int>(std::floor(inner.y + half - 0.5)) + 1);
        double const row = surface_row(excess, column, from, end);
        if (!std::isnan(row))
            points.push_back({frame.x(column), (frame.circle.y - row) * frame.pixel_size()});
    }
    return points;
}

SegmentProfile profile_of(std::vector<Point> const& points, PictureFrame const& frame, int segments)
{
    SegmentProfile profile;
    double const width = 2 * frame.radius / segments;
    for (int k = 0; k < segments; ++k) {
        double const left = -frame.radius + k * width, middle = left + 0.5 * width;
        std::vector<double> x, z;
        double sum = 0;
        for (auto const& [at, height] : points)
            if (at >= left && at < left + width)
                x.push_back(at - middle), z.push_back(height), sum += height;
        profile.x.push_back(middle);
        double const wanted = least_columns * width / frame.pixel_size();
        if (x.empty() || static_cast<double>(x.size()) < std::floor(wanted))
            profile.z.push_back(none);
        else
            profile.z.push_back(x.size() < 3 ? sum / static_cast<double>(x.size())
                                             : fit_line(x, z).intercept);
    }
    return profile;
}

} // namespace

BedPicture read_bed(Cut const& cut, PictureFrame const& frame, BedReading const& reading)
{
    auto const inner = frame.circle.scaled(1 - reading.rim);
    BedPicture bed;
    bed.mask = closed(without_rim(cut.mask(), inner, frame.circle), reading.closing);
    bed.fill = covered_share(bed.mask, frame.circle);
    auto const points = surface_points(cut.excess, frame, inner);
    auto const line = fit_principal_line(points);
    bed.surface_columns = line.points;
    bed.angle_deg = frame.rotation == Rotation::clockwise ? -line.angle_deg : line.angle_deg;
    bed.straightness = line.r2;
    if (line.points < 3)
        bed.angle_deg = bed.straightness = none;
    bed.profile = profile_of(points, frame, reading.segments);
    return bed;
}

void require_climb(BedPicture const& bed, Rotation rotation)
{
    if (bed.angle_deg < -falls_back_deg)
        throw InputError(fmt::format(
            "the bed climbs to the {0} by {1:.3g} deg, but a drum that turns {2} carries it to the {3}; give "
            "the "
            "rotation as the camera sees it: {4}",
            rotation == Rotation::clockwise ? "right" : "left", -bed.angle_deg, word_for(rotation),
            rotation == Rotation::clockwise ? "left" : "right",
            word_for(rotation == Rotation::clockwise ? Rotation::counterclockwise : Rotation::clockwise)));
}

double area_mismatch(Mask const& a, Mask const& b, PictureFrame const& frame, double inside_radius)
{
    if (a.columns != b.columns || a.rows != b.rows)
        throw InputError(
            fmt::format("pictures of {} x {} and {} x {} pixels cannot be compared; both must have "
                        "the same raster",
                        a.columns, a.rows, b.columns, b.rows));
    return static_cast<double>(differing_pixels(a, b, frame.circle.scaled(inside_radius))) *
           frame.pixel_size() * frame.pixel_size();
}

PhotographedBed read_photograph(GreyImage const& image, PictureFrame const& frame,
                                PhotographReading const& reading)
{
    require_whole(frame.circle, image.columns, image.rows);
    auto const inner = frame.circle.scaled(1 - reading.bed.rim);
    PhotographedBed read{.cut = reading.threshold ? cut_at(image, inner, *reading.threshold)
                                                  : cut_midway(image, inner),
                         .bed = {}};
    require_clear_rim(read.cut, inner);
    if (!reading.trust_circle)
        require_circle(image, frame.circle, 0.5 * (read.cut.light + read.cut.bed));
    read.bed = read_bed(read.cut, frame, reading.bed);
    require_climb(read.bed, frame.rotation);
    return read;
}

} // namespace demens::observe
