#pragma once

#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_block.hpp"

#include <vector>

namespace demens::dem {

//! Sums over the lanes of all blocks, so that adding a block is one loop over lanes [J].
struct alignas(64) LossSums
{
    ContactBlock::Lane damping{}, friction{}, rolling{}, cohesion{};

    //! A share of what the contacts of a block have lost since the step before.
    void add(ContactBlock const& block, double share)
    {
        for (int l = 0; l < block.count; ++l) {
            damping[l] += share * block.lost_to_damping[l];
            friction[l] += share * block.lost_to_friction[l];
            rolling[l] += share * block.lost_to_rolling[l];
            cohesion[l] += share * block.lost_to_cohesion[l];
        }
    }
};

//! What the energy ledger has added up: what cannot be seen in particles and contacts. Of this process.
struct EnergyTally
{
    LossSums losses = {};
    std::vector<WallLoad> loads_before = {};                   //!< on each wall, in the step before
    double work_of_walls = 0, brought_in = 0, turned_over = 0; //!< [J]
    double drag_to_come = 0, vibration_to_come = 0; //!< work of these loads until the next step [J]
};

} // namespace demens::dem
