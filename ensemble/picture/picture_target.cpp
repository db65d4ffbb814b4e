#include "ensemble/picture/picture_target.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace demens::ensemble {
namespace {

//! Height of the line through a surface, at x [m]: through the middle of what is seen of it, at its angle.
double on_line(observe::BedPicture const& bed, observe::PictureFrame const& frame, double x)
{
    double sum_x = 0, sum_z = 0, count = 0;
    for (std::size_t k = 0; k < bed.profile.x.size(); ++k)
        if (!std::isnan(bed.profile.z[k])) {
            sum_x += bed.profile.x[k];
            sum_z += bed.profile.z[k];
            ++count;
        }
    if (count == 0)
        return std::numeric_limits<double>::quiet_NaN();
    double const climb = frame.rotation == observe::Rotation::clockwise ? -bed.angle_deg : bed.angle_deg;
    return sum_z / count + (x - sum_x / count) * std::tan(climb * std::numbers::pi / 180);
}

} // namespace

std::vector<rig::ResponseInfo> responses_of(PictureTarget const& target)
{
    std::vector<rig::ResponseInfo> responses = {
        {"picture_mismatch_mm2", "mm2", "area that the bed covers in one of picture and photograph alone",
         rig::ResponseKind::accuracy},
        {"picture_area_percent", "%", "part of the drum's circle that the bed covers in the picture"},
        {"picture_angle_deg", "deg", "inclination of the bed's surface in the picture"},
        {"picture_r2", "1", "straightness of the bed's surface in the picture"}};
    for (std::size_t const k : target.segments)
        responses.push_back(
            {fmt::format("picture_{}_mm", k + 1), "mm",
             fmt::format("height of the surface in the picture, {:.4g} mm to the {} of the axis",
                         1e3 * std::abs(target.bed.profile.x[k]),
                         target.bed.profile.x[k] < 0 ? "left" : "right")});
    return responses;
}

observe::GreyImage simulated_picture(PictureTarget const& target, std::vector<rig::Profile> const& profiles)
{
    auto const picture = std::find_if(profiles.begin(), profiles.end(),
                                      [](rig::Profile const& profile) { return profile.name == "picture"; });
    auto const &from = target.simulated, &to = target.frame;
    observe::GreyImage own(from.columns, from.rows);
    if (picture == profiles.end() || picture->curve.rows() != own.darkness.size())
        throw InputError("the run has kept no picture");
    auto const& shares = picture->curve.columns[1];
    std::transform(shares.begin(), shares.end(), own.darkness.begin(),
                   [](double share) { return static_cast<float>(share); });

    observe::GreyImage seen(to.columns, to.rows);
    double const sense = to.rotation == from.rotation ? 1 : -1;
    for (int row = 0; row < to.rows; ++row)
        for (int column = 0; column < to.columns; ++column)
            seen.at(column, row) =
                static_cast<float>(own.between(from.circle.x + sense * to.x(column) / from.pixel_size(),
                                               from.circle.y - to.z(row) / from.pixel_size()));
    return seen;
}

std::vector<double> responses_of(PictureTarget const& target, rig::RunResult const& result)
{
    auto const bed = read_bed(cut_through(simulated_picture(target, result.profiles), target.simulated_cut),
                              target.frame, target.reading);
    std::vector<double> responses = {
        1e6 * area_mismatch(bed.mask, target.bed.mask, target.frame, target.reading.inside_radius),
        100 * bed.fill, bed.angle_deg, bed.straightness};
    for (std::size_t const k : target.segments) {
        double const height = bed.profile.z[k];
        responses.push_back(1e3 *
                            (std::isnan(height) ? on_line(bed, target.frame, bed.profile.x[k]) : height));
    }
    return responses;
}

} // namespace demens::ensemble
