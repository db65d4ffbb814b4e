#include "demens/observe/picture/bed_picture.hpp"

#include "demens/base/not_a_number.hpp"
#include "demens/observe/picture/rim.hpp"
#include "demens/observe/principal_line.hpp"
#include "demens/observe/surface.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace demens::observe {
namespace {

constexpr double explained = 0.95;     //!< share of a column's pixels that a surface must explain
constexpr double least_columns = 0.8;  //!< share of a segment's columns that must have a surface
constexpr double most_missing = 0.1;   //!< share of the columns between a surface's ends that may have none
constexpr double reaches_rim = 0.9;    //!< share of the radius looked at, from which on a surface is whole
constexpr double column_scatter = 0.3; //!< of a column's surface by noise that is enough [pixels]
constexpr int most_smoothing = 9;      //!< [pixels]
constexpr double falls_back_deg = 3;   //!< a bed that descends by more, as the drum turns, is seen mirrored

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
    return is_at_end || fewest > (1 - explained) * (end - from) ? not_a_number : sum / ties;
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

//! Mean darkness over a pixel downwards, about the surface, as far as two pixels from it.
double slope_at(GreyImage const& excess, PictureFrame const& frame, std::vector<Point> const& points)
{
    double sum = 0;
    for (auto const& [x, z] : points) {
        double const column = frame.circle.x + x / frame.pixel_size(),
                     row = frame.circle.y - z / frame.pixel_size();
        sum += (excess.between(column, row + 2) - excess.between(column, row - 2)) / 4;
    }
    return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

//! Where points end and how many columns between are without.
void note_ends(BedPicture& bed, std::vector<Point> const& points, PictureFrame const& frame,
               Circle const& inner)
{
    if (points.empty())
        return;
    auto const from_axis = [&](Point const& p) {
        return std::hypot(p[0], p[1]) / (inner.radius * frame.pixel_size());
    };
    bed.ends = {from_axis(points.front()), from_axis(points.back())};
    auto const columns =
        static_cast<int>(std::lround((points.back()[0] - points.front()[0]) / frame.pixel_size())) + 1;
    bed.missing_columns = columns - static_cast<int>(points.size());
}

//! Over how many pixels, n x n, noise must be averaged so that it moves the surface of a column little.
int smoothing_against(double noise, double slope)
{
    if (!(slope > 0))
        return 1;
    int n = 1;
    while (n < most_smoothing && noise / n > column_scatter * slope)
        n += 2;
    return n;
}

//! \throws InputError when noise may move the height over a segment by more than half a pixel
void require_known(double noise, PhotographedBed const& read, PictureFrame const& frame, int segments)
{
    // Means over n pixels are the same in n columns.
    double const columns = std::max(1.0, 2 * frame.circle.radius / segments / read.smoothing);
    double const scatter = noise / read.smoothing / read.bed.slope / std::sqrt(columns);
    if (read.bed.surface_columns > 0 && !(2.5 * scatter <= 0.5))
        throw InputError(fmt::format("the picture is too noisy for its blur: from pixel to pixel darkness "
                                     "scatters by {:.2g} of 255, and passes "
                                     "from bed to light by {:.2g} a pixel, so that the surface is known "
                                     "within {:.2g} pixels at best; at most "
                                     "0.5; take the mean of several pictures, or fewer segments",
                                     255 * noise, 255 * read.bed.slope, 2.5 * scatter));
}

//! \throws InputError when the surface is lost on the way from rim to rim
void require_surface(BedPicture const& bed)
{
    if (bed.surface_columns < 3)
        throw InputError("no surface is seen: nowhere does light stand above a bed");
    for (std::size_t k = 0; k < 2; ++k)
        if (bed.ends[k] < reaches_rim)
            throw InputError(
                fmt::format("the surface is lost on the {}, at {:.2g} of the radius: there, no light above "
                            "a bed explains the pixels; look for shadows, glare or dirt on the window",
                            k == 0 ? "left" : "right", bed.ends[k]));
    if (bed.missing_columns > most_missing * (bed.surface_columns + bed.missing_columns))
        throw InputError(
            fmt::format("the surface is lost in {} of the {} columns of pixels between its ends; look for "
                        "shadows, glare or dirt on the window",
                        bed.missing_columns, bed.surface_columns + bed.missing_columns));
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
            profile.z.push_back(not_a_number);
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
    bed.slope = slope_at(cut.excess, frame, points);
    note_ends(bed, points, frame, inner);
    bed.angle_deg = frame.rotation == Rotation::clockwise ? -line.angle_deg : line.angle_deg;
    bed.straightness = line.r2;
    if (line.points < 3)
        bed.angle_deg = bed.straightness = not_a_number;
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
    auto const read = [&](int smoothing) {
        auto wanted = reading.bed; // means must not reach into the rim
        wanted.rim += 0.5 * (smoothing - 1) / frame.circle.radius;
        auto const inner = frame.circle.scaled(1 - wanted.rim);
        PhotographedBed now{.cut = reading.threshold
                                       ? cut_at(smoothed(image, smoothing), inner, *reading.threshold)
                                       : cut_midway(image, inner, smoothing),
                            .bed = {},
                            .smoothing = smoothing};
        require_clear_rim(now.cut, inner);
        now.bed = read_bed(now.cut, frame, wanted);
        return now;
    };
    auto result = read(1);
    double const noise = noise_of(image, result.cut, frame.circle.scaled(1 - reading.bed.rim));
    if (int const n = smoothing_against(noise, result.bed.slope); n > 1)
        result = read(n);
    if (!reading.trust_circle)
        require_circle(smoothed(image, std::min(3, result.smoothing)), frame.circle,
                       result.cut.bed - result.cut.light);
    require_known(noise, result, frame, reading.bed.segments);
    require_surface(result.bed);
    require_climb(result.bed, frame.rotation);
    return result;
}

} // namespace demens::observe
