#pragma once

#include "ensemble/file/parts.hpp"

#include <mpi.h>

namespace demens::ensemble {

//! A wave whose shards are all there.
struct FinishedWave
{
    Wave wave;                       //!< as planned, with its wall time and groups
    std::vector<std::uint32_t> crcs; //!< of the shard of each run
};

//! All ranks read the shards of the wave, each its own rows, and write them together into a copy of the
//! campaign file, which takes the file's place when it has been read back. Collective. \throws FileError on
//! all ranks
void gather(MPI_Comm communicator, std::filesystem::path const& file, CampaignInput const& input,
            Parts const& parts, FinishedWave const& finished);

} // namespace demens::ensemble
