#pragma once

#include "tests/parity/contact_case.hpp"

namespace demens::parity {

//! What the blocks of the CPU engine make of a case; against walls `torque_j` is left at 0.
struct BlockResults
{
    Results results;
    struct WallSum
    {
        Vector3 force, torque;
    };
    std::vector<WallSum> wall_sums; //!< what acts on the walls, moments x walls
};
BlockResults evaluate_in_blocks(Scene const& scene, Case const& the_case);

} // namespace demens::parity
