#pragma once

#include "demens/base/vector3.hpp"
#include "demens/observe/picture/bed_picture.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace demens::cli {

//! How what is observed is printed.
enum class ObserveFormat
{
    text,
    csv,
    json,
    targets
};

//! Whether files are observed one by one, or their mean.
enum class Take
{
    usual, //!< photographs one by one, frames as their mean over time
    each,
    mean
};

//! What the command line says, as it stands there.
struct ObserveText
{
    std::vector<std::string> files, references;
    std::string circle_px, threshold = "auto", centre_mm = "0,0,0", frames_unit = "m", take = "usual";
    std::string rotation = "counterclockwise", frames_rotation = "counterclockwise", axis = "y", up = "z";
    double radius_mm = 0, turned_deg = 0, occupancy = 0.5;
    observe::BedReading bed;
    int pixels = 400;
    bool trust_circle = false, csv = false, json = false, targets = false;
    std::string folder;
};

//! The same, checked.
struct ObserveArguments
{
    //! \throws InputError
    explicit ObserveArguments(ObserveText const& text);

    std::vector<std::string> files, references;
    std::optional<observe::Circle> circle; //!< none: the largest that a picture holds
    double radius;                         //!< of the drum [m]
    double turned_deg;                     //!< counterclockwise, before a photograph is read
    observe::PhotographReading photograph;
    observe::Rotation rotation, frames_rotation;
    double occupancy;    //!< share of the frames that must cover a pixel
    std::size_t axis[3]; //!< which coordinate of a frame's points to the right, along the drum's axis, up
    double sense;        //!< of the first: -1 when it points to the left
    Vector3 centre;      //!< of the drum in the frames' own coordinates [m]
    double unit;         //!< of the frames' lengths that carry none [m]
    int pixels;          //!< along the diameter, where no photograph says it
    Take take;
    ObserveFormat format;
    std::string folder; //!< for pictures and profiles; empty: none
};

void add_options(CLI::App& command, ObserveText& text);

} // namespace demens::cli
