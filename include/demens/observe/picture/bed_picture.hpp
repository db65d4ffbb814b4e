#pragma once

#include "demens/observe/picture/cut.hpp"

#include <array>
#include <optional>

namespace demens::observe {

//! How a picture of a drum's bed is read.
struct BedReading
{
    int closing = 7;   //!< pixels of the closing of the mask, odd; 1: none
    double rim = 0.04; //!< outermost share of the radius that is not looked at
    int segments = 20; //!< of the drum's diameter, for the profile
    double inside_radius =
        0.7745966692414834; //!< share of the radius within which masks are compared: sqrt(0.6)
};

//! Height of the bed's surface over the drum's horizontal diameter, both from the drum's axis, in the
//! picture.
struct SegmentProfile
{
    std::vector<double> x; //!< middles of the segments, to the right [m]
    std::vector<double> z; //!< [m]; NaN where there is no surface
};

//! What is read off a picture of a drum's end window. The same for a photograph and for a simulation's
//! picture.
struct BedPicture
{
    Mask mask;       //!< where grains are inside the circle, closed
    double fill = 0; //!< share of the circle that they cover [-]
    double angle_deg =
        0; //!< of the surface, positive when it climbs as the drum turns; NaN without a surface
    double straightness = 0; //!< R^2 of the line through the surface [-]
    SegmentProfile profile;
    int surface_columns = 0; //!< of pixels in which there is a surface
    //! Where the surface ends, left and right: from the drum's axis over the radius that is looked at [-].
    std::array<double, 2> ends{};
    int missing_columns = 0; //!< between its ends, in which there is none
    double slope = 0;        //!< passage from bed to light: darkness over a pixel downwards, at the surface
};

//! Reads a cut picture. The surface of a column of pixels is where grains below and light above explain most
//! of its pixels, then where darkness passes the cut between two pixels; columns of which they explain less
//! than 9 in 10 have none, and so have those that the surface leaves through the rim. The profile's height is
//! that of the line through the surface of a segment, in its middle; there is none with fewer than 4 in 5
//! columns.
BedPicture read_bed(Cut const& cut, PictureFrame const& frame, BedReading const& reading);

//! \throws InputError when the bed climbs on the other side than that to which a drum turning so carries it
void require_climb(BedPicture const& bed, Rotation rotation);

//! Area that only one of two masks covers, inside the reading's share of the radius [m^2].
//! \throws InputError when the pictures differ in size
double area_mismatch(Mask const& a, Mask const& b, PictureFrame const& frame, double inside_radius);

//! What is said of a photograph beside its pixels.
struct PhotographReading
{
    //! Darkness of the cut [0 to 1]; none: midway between bed and light, wherever these are.
    std::optional<double> threshold;
    //! Whether the circle is right even if the rim that is seen is another.
    bool trust_circle = false;
    BedReading bed;
};

//! Reads a photograph and checks what can be: that the circle is whole and is the rim that is seen, that bed
//! and light are apart, that the surface reaches from rim to rim and climbs as the drum turns. Noise is taken
//! out by means over as few pixels as it needs. \throws InputError
struct PhotographedBed
{
    Cut cut;
    BedPicture bed;
    int smoothing; //!< n x n pixels that means were taken over; 1: none
};
PhotographedBed read_photograph(GreyImage const& image, PictureFrame const& frame,
                                PhotographReading const& reading);

} // namespace demens::observe
