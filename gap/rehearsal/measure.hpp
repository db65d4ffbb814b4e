#pragma once

#include "ensemble/session.hpp"
#include "gap/rehearsal/draw.hpp"

#include <filesystem>
#include <mpi.h>
#include <string>

namespace demens::gap {

//! Simulates what would be measured in a case, in a campaign file of its own, which it goes on with where it
//! is there. Collective. \return the campaign's text with these values, on rank 0; empty when asked to stop.
//! \throws InputError for targets that are curves or pictures
std::string measured_campaign(MPI_Comm communicator, ensemble::CampaignInput const& input,
                              RehearsedEffects const& effects, CaseTruth const& truth,
                              std::filesystem::path const& file, int repeats);

} // namespace demens::gap
