#pragma once

#include "demens/observe/picture/bed_picture.hpp"
#include "demens/rig/rig.hpp"

#include <string>
#include <vector>

namespace demens::ensemble {

//! A photograph of a drum's end window, to be met by the picture that the rig keeps: each segment of the
//! bed's surface is a target, and what else the same functions read off both is told beside it.
struct PictureTarget
{
    observe::PictureFrame frame;     //!< of the photograph
    observe::PictureFrame simulated; //!< of the rig's picture
    observe::BedReading reading = {};
    double simulated_cut = 0.5;   //!< share of the frames from which on a pixel of the rig's picture is bed
    observe::BedPicture bed = {}; //!< as photographed
    std::vector<std::size_t> segments =
        {};                              //!< of the profile, those with a surface within the radius compared
    OptionValues given = {};             //!< its keys, as its author wrote them
    std::vector<double> circle = {};     //!< x, y and radius [pixels], as given; empty: the largest circle
    std::vector<std::string> files = {}; //!< of which the mean is taken
};

//! What the picture adds to the responses of its experiment: mismatch, area, angle and straightness, then the
//! heights of the segments.
std::vector<rig::ResponseInfo> responses_of(PictureTarget const& target);
//! The same of a run. Where its surface leaves a segment, the line through the rest of the surface goes on
//! there. NaN without a surface.
std::vector<double> responses_of(PictureTarget const& target, rig::RunResult const& result);
//! The rig's picture on the photograph's raster, as the camera would see it. \throws InputError when the run
//! has none
observe::GreyImage simulated_picture(PictureTarget const& target, std::vector<rig::Profile> const& profiles);

//! How many of the responses come before the segments.
constexpr std::size_t picture_numbers = 4;

} // namespace demens::ensemble
