#pragma once

#include "ensemble/file/parts.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/mpi/mpi_team.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

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
    //! Whether this rank is the first of its group, the one that takes runs and stores them.
    bool leads() const { return mine_ >= 0 && rank_of(group_) == 0; }
    //! This rank's group, as those who share a simulation; null where it has one rank.
    dem::Team* team() const { return team_.get(); }
    //! What the first rank of this rank's group gives; waits for it without taking the core. Collective.
    int from_first(int value) const;

  private:
    int count_ = 0, mine_ = -1;
    Communicator group_;
    std::unique_ptr<MpiTeam> team_;
};

//! What a wave is to be run with; the same on all ranks.
struct WaveWork
{
    std::vector<int> pending;    //!< rows, in the order in which they begin
    std::vector<int> suspicious; //!< rows to run one at a time after the others
    std::vector<double> seconds; //!< expected wall time of every row of the wave
    std::vector<double> limits;  //!< [s] wall time after which its run is given up; 0: none
    double clock = 0;            //!< [s] working time of the wave so far
    int done = 0, failed = 0;    //!< runs of the wave that are complete
};

//! Runs what a wave lacks: every group takes the next run when it is free, and all its ranks simulate it. No
//! exception of a run leaves it.
class WaveRunner
{
  public:
    WaveRunner(MPI_Comm communicator, Groups const& groups, CampaignInput const& input, Parts const& parts);

    //! Collective. Ends when nothing is left or a stop is requested. \throws FileError on all ranks when a
    //! rank cannot write
    void run(Wave const& wave, WaveWork const& work, Journal* journal, std::FILE* progress);

  private:
    class Pass;

    MPI_Comm communicator_;
    Groups const& groups_;
    CampaignInput const& input_;
    Parts const& parts_;
};

//! Waits for all ranks without taking their cores.
void patient_barrier(MPI_Comm communicator);

} // namespace demens::ensemble
