#pragma once

#include "ensemble/file/parts.hpp"
#include "ensemble/run/wave_work.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mpi.h>
#include <optional>
#include <vector>

namespace demens::ensemble {

//! What is left to do of a wave, and the check sums of the shards that are there.
struct SeenWave
{
    WaveWork work;
    std::vector<std::uint32_t> crcs; //!< by row; on rank 0
};

//! What happens to the waves of a campaign but their runs, in the campaign and in its file. Every member
//! function is collective over `communicator`, all ranks or rank 0 alone; what it changes, the ranks of the
//! communicator know.
class WaveKeeper
{
  public:
    WaveKeeper(std::filesystem::path file, Campaign& campaign, Parts const& parts)
        : file_(std::move(file)), campaign_(campaign), parts_(parts)
    {
    }

    //! Adds a wave. The arguments of rank 0 count.
    void plan(MPI_Comm communicator, WavePlan const& plan);
    //! Looks at the shards of a wave; runs that are not begun again get their status here. No run of the wave
    //! may be in progress. \param journal of rank 0
    SeenWave look_at(MPI_Comm communicator, Wave const& wave, Journal* journal) const;
    //! The groups begin with the runs of a wave, or have nothing left to do: the time from an end to a
    //! beginning is stored with the wave.
    void groups_begin(int number);
    void groups_end() { idle_since_ = Clock::now(); }
    //! Moves the results of a wave whose runs are all over from the shards into the file.
    void gather(MPI_Comm communicator, int number, SeenWave const& seen, int groups);
    //! Stores what the calibration made of the runs up to a wave. Rank 0's array counts.
    void store_analysis(MPI_Comm communicator, int number, std::vector<NamedArray> const& analysis);

  private:
    WaveState inspect_and_quarantine(MPI_Comm communicator, Wave const& wave, Journal* journal) const;
    double wall_time_until(int number, double clock) const;

    using Clock = std::chrono::steady_clock;
    std::optional<Clock::time_point> idle_since_;
    std::map<int, double> time_before_; //!< [s] by wave
    std::filesystem::path file_;
    Campaign& campaign_;
    Parts const& parts_;
};

} // namespace demens::ensemble
