#pragma once

#include "demens/rig/rig.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace demens::report {

//! Whether a picture can be looked at from other sides, for which the page needs one more number a particle.
enum class Turning
{
    no,
    yes
};

//! Views of the particles from the front, all with one frame: the vertical is z, the horizontal the wider of
//! x and y. Lengths are whole multiples of `quantum` [m] from `origin`; particles are ordered from the back
//! to the front.
//! \param turning of the last one
nlohmann::json pictures_of(std::vector<rig::Snapshot> const& snapshots, Turning turning = Turning::yes);
//! The frames of a film, coarser, and of each as many particles in front as make 40,000 in all.
nlohmann::json film_of(std::vector<rig::Snapshot> const& frames);
//! Columns over the first one, thinned to what a plot can show.
nlohmann::json columns_of(rig::Series const& series);

} // namespace demens::report
