#pragma once

#include "demens/observe/hull_outline.hpp"
#include "demens/rig/programme/bench.hpp"

#include <span>
#include <vector>

namespace demens::rig {

//! The outlines of all grains: spheres, those of clumps, and hulls, as they are.
struct SeenGrains
{
    std::span<dem::Place const> balls;
    std::vector<observe::HullOutline> hulls;

    std::vector<dem::Place> kept = {}; //!< `balls`, where some that are there are read for hulls
};

//! ... at a moment, made once.
SeenGrains const& seen_grains(Look& look);

//! Whether a particle is one of those that a hull is read as. \param hulls in the order of their ids
bool is_of_hull(std::vector<dem::HullPlace> const& hulls, dem::ParticleId id);

} // namespace demens::rig
