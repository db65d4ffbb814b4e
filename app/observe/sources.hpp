#pragma once

#include "app/observe/arguments.hpp"

namespace demens::cli {

//! A picture that was read: a photograph, a frame, or the mean of several.
struct Observed
{
    std::string name;
    observe::GreyImage picture;
    observe::PictureFrame frame;
    observe::Cut cut;
    observe::BedPicture bed;
    int smoothing; //!< pixels of the means that took noise out; 1: none
};

//! What the files show, and what these are compared with, all on rasters of the photographs if there are any.
struct Observations
{
    std::vector<Observed> pictures;
    std::optional<Observed> reference;
};

//! \throws InputError with the file's name
Observations observe_files(ObserveArguments const& arguments);

} // namespace demens::cli
