#pragma once

#include "ensemble/campaign.hpp"

#include "demens/base/bytes.hpp"

#include <filesystem>
#include <mpi.h>

namespace demens::ensemble {

//! Rank 0 reads the file and every rank gets the campaign, so that none sees an older state of a network
//! disk. Collective. \throws InputError
Campaign read_for_all(MPI_Comm communicator, std::filesystem::path const& file, Rigs const& rigs);
//! A wave as a message: a campaign file in memory with this wave only.
Bytes packed_wave(Wave const& wave, CampaignInput const& input);
Wave unpacked_wave(Bytes const& message, int number, CampaignInput const& input);
//! Rank 0's wave of that number takes the place of the same wave of the others, or is added. Collective.
void share_wave(MPI_Comm communicator, Campaign& campaign, int number);

} // namespace demens::ensemble
