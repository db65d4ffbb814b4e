#pragma once

#include "ensemble/campaign.hpp"
#include "report/analysis.hpp"
#include "report/handover/folder.hpp"

namespace demens::report {

//! Writes what other programs and people need of the best point: the material card, parameters and decks for
//! LIGGGHTS and LAMMPS, parameters for MFiX, EDEM and Rocky, and how all of them map. The analysis must have
//! a best run.
void hand_over(Folder& folder, ensemble::Campaign const& campaign, Analysis const& analysis);

} // namespace demens::report
