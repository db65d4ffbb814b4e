#pragma once

#include "demens/rig/rig.hpp"

#include <nlohmann/json.hpp>

namespace demens::report {

//! A view of the particles from the front: the vertical is z, the horizontal the wider of x and y. Lengths are
//! whole multiples of `quantum` [m] from `origin`; particles are ordered from the back to the front.
nlohmann::json picture_of(rig::Snapshot const& snapshot);
//! Columns over time, thinned to what a plot can show.
nlohmann::json series_of(rig::Series const& series);

} // namespace demens::report
