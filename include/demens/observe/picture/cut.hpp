#pragma once

#include "demens/observe/picture/mask.hpp"

namespace demens::observe {

//! A picture cut into grains and light.
struct Cut
{
    GreyImage excess;          //!< darkness less that of the cut there: grains where it is above 0
    double level = 0;          //!< darkness of the cut; where it follows the light, its median
    double light = 0, bed = 0; //!< darkness of either side, medians

    Mask mask() const;
};

//! Cut at a darkness [0 to 1], whatever that leaves: a simulation's picture is cut at a share of the frames.
Cut cut_through(GreyImage const& image, double level);

//! Cut at a darkness [0 to 1] of a photograph. Only what is inside the circle is judged.
//! \throws InputError when that leaves nothing on a side, or when the sides are not clearly apart
Cut cut_at(GreyImage const& image, Circle const& inside, double level);

//! Cut midway between bed and light, both as they are at that place. Otsu's threshold (Otsu 1979) tells them
//! apart at first; then darkness of either is a polynomial of second order in the place, fitted away from the
//! surface, so that neither light that is uneven nor blur moves the cut off the middle. Means over
//! `smoothing` pixels, odd, along both directions are cut; light that is cut off at white leaves the least
//! distances right, to which the polynomials are fitted, but not a mean: they are fitted to the picture as it
//! is. \throws InputError when the sides are not clearly apart, or when what the polynomials leave over may
//! move the surface by more than half a pixel
Cut cut_midway(GreyImage const& image, Circle const& inside, int smoothing = 1);

//! How much darkness scatters from pixel to pixel: standard deviation, on the side of a cut where that is
//! more.
double noise_of(GreyImage const& image, Cut const& cut, Circle const& inside);

//! The darkness for which the classes on either side differ most from each other, over those inside a circle
//! (Otsu 1979, in 256 steps between the lightest and the darkest). \throws InputError when all are the same
double otsu_level(GreyImage const& image, Circle const& inside);

} // namespace demens::observe
