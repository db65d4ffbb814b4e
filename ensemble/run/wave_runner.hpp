#pragma once

#include "ensemble/file/parts.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/mpi/mpi_team.hpp"
#include "ensemble/run/wave_work.hpp"

#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace demens::ensemble {

//! \throws InputError where this process lacks what the runs are to be computed on
void require_engine(RunOptions const& run);

//! Ranks split into groups of a fixed size; ranks that do not fill a group have none and only help to gather.
class Groups
{
  public:
    //! \throws InputError when the ranks do not fill one group
    Groups(MPI_Comm communicator, int ranks_per_group);

    int count() const { return count_; }
    //! This rank's group; -1: none.
    int mine() const { return mine_; }
    //! The ranks that have a group; null on others.
    MPI_Comm all() const { return all_; }
    //! Whether this rank is the first of its group, the one that takes runs and stores them.
    bool leads() const { return mine_ >= 0 && rank_of(group_) == 0; }
    //! This rank's group, as those who share a simulation; null where it has one rank.
    dem::Team* team() const { return team_.get(); }
    //! What the first rank of this rank's group gives; waits for it without taking the core. Collective.
    int from_first(int value) const;

  private:
    int count_ = 0, mine_ = -1;
    Communicator all_, group_;
    std::unique_ptr<MpiTeam> team_;
};

//! Runs what waves lack: every group takes the next run when it is free, and all its ranks simulate it. No
//! exception of a run leaves it.
class WaveRunner
{
  public:
    //! What rank 0 adds when the pending runs of a wave are over, if anything; called between and during its
    //! own runs.
    using Successor = std::function<std::optional<QueuedWave>(QueuedWave const& over)>;

    WaveRunner(MPI_Comm communicator, Groups const& groups, CampaignInput const& input, Parts const& parts);

    //! All pending runs, or, where the first wave has none, its suspicious ones by one group. Ends when
    //! nothing is left or a stop is requested. The waves are the same on all ranks. Collective.
    //! \throws FileError on all ranks when a rank cannot write
    void run(std::deque<QueuedWave> waves, Journal* journal, std::FILE* progress,
             Successor const& successor = {});

  private:
    class Pass;

    MPI_Comm communicator_;
    Groups const& groups_;
    CampaignInput const& input_;
    Parts const& parts_;
};

} // namespace demens::ensemble
