#pragma once

#include "ensemble/file/parts.hpp"

#include <mpi.h>

namespace demens::ensemble {

//! What is there of a wave, on rank 0; nothing on the others. Rank 0 reads the journals, every rank looks at
//! its part of the shards that they name. No run may be in progress. Collective. \param histories what the
//! journals say, on rank 0
WaveState inspect(MPI_Comm communicator, Parts const& parts, Wave const& wave, CampaignInput const& input,
                  std::map<int, RunHistory>& histories);

} // namespace demens::ensemble
