#pragma once

#include "demens/contact/evaluation/evaluate_contact.hpp"

namespace demens::dem::cuda {

//! What the energy ledger adds up, in parts: one for each place among the particles of a slot, whoever is
//! there; their sum counts. All in J.
struct Tally
{
    double damping, friction, rolling, cohesion; //!< lost
    double work_of_walls, brought_in;
    double drag_to_come, vibration_to_come; //!< work of these loads until the next step

    DEMENS_FUNCTION void lose(contact::Losses const& lost, double share)
    {
        damping += share * lost.damping;
        friction += share * lost.friction;
        rolling += share * lost.rolling;
        cohesion += share * lost.cohesion;
    }
};

} // namespace demens::dem::cuda
