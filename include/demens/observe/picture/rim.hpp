#pragma once

#include "demens/observe/picture/cut.hpp"

#include <optional>

namespace demens::observe {

//! A drum's rim as it is seen in a picture.
struct SeenRim
{
    Circle
        circle; //!< outer edge of what is dark, where the outside is light; else the edge of the light inside
    double arc_deg; //!< along how much of the circumference it was found
};

//! Looks for the rim near a circle, where darkness changes by a quarter of the contrast of bed and light;
//! none where too little of the circumference shows one for it to be known within a quarter of a pixel.
std::optional<SeenRim> find_rim(GreyImage const& image, Circle const& near, double contrast);

//! \throws InputError when the picture shows a rim whose middle is more than half a pixel off that of the
//! circle, or whose radius differs by more than a pixel: the profile could be off by half a pixel; and when
//! no rim is seen that tells
void require_circle(GreyImage const& image, Circle const& circle, double contrast);

//! \throws InputError when the picture is dark all around along a circle: a rim reaches into it
void require_clear_rim(Cut const& cut, Circle const& inner);

} // namespace demens::observe
