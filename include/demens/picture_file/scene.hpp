#pragma once

#include "demens/observe/snapshot.hpp"
#include "demens/picture_file/picture_file.hpp"

namespace demens::picture_file {

//! Particles and walls as seen from the front: the vertical is z, the horizontal the wider of x and y; lit
//! from above on the left, those in front hide others. Outlines of walls are drawn over them. \param columns
//! width [pixels]; the height follows, at most twice that
ColourImage picture_of(observe::Snapshot const& snapshot, int columns = 800);

} // namespace demens::picture_file
