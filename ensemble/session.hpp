#pragma once

#include "ensemble/campaign.hpp"

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <mpi.h>
#include <optional>
#include <utility>
#include <vector>

namespace demens::ensemble {

//! How the execution of a wave ended.
enum class WaveEnd
{
    complete, //!< every run has a status and the campaign file holds them
    drained //!< asked to stop (SIGUSR1, SIGTERM), or runs are left to others: go on later; the program exits
            //!< with 75
};

//! What rank 0 makes of a campaign whose last wave is open and whose other waves are complete.
struct LookAhead
{
    //! of complete waves, with their numbers
    std::vector<std::pair<int, std::vector<NamedArray>>> analyses;
    std::optional<WavePlan> next; //!< none: what follows depends on the open wave
};
using Foresight = std::function<LookAhead(Campaign const&)>;

//! What a session can be told beside the campaign.
struct SessionOptions
{
    Rigs const& rigs = rig::all_rigs(); //!< must outlive the session
    std::FILE* progress = stderr;       //!< where rank 0 shows how a wave goes on; null: nowhere
    bool simulates = true;              //!< false: only takes in what tasks of a job array have left
};

//! A campaign file open for work by all ranks of a communicator. Every member function is collective, and
//! every rank sees the same campaign.
class Session
{
  public:
    //! Opens a campaign file and takes in the shards of an interrupted wave. \throws InputError when the file
    //! is not a campaign, is of a newer format, or is in use by another session.
    Session(MPI_Comm communicator, std::filesystem::path const& file, SessionOptions const& options = {});
    ~Session();

    Campaign const& campaign() const;
    //! Number of groups that simulate at a time.
    int groups() const;

    //! Adds a wave. The plan is in the file when this returns. The arguments of rank 0 count.
    void plan_wave(WavePlan const& plan);
    //! The same with all experiments that calibrate and their replicates at each design point (own units).
    void plan_wave(WavePurpose purpose, std::vector<std::vector<double>> const& points);
    //! Runs what waves still lack, first wave first, longest predicted run first, and gathers each into the
    //! file. \param foresight called on rank 0 while the last wave is being run, so that groups which find
    //! nothing left of it go on with the next; what it says must not depend on the runs of the open wave
    WaveEnd run_waves(Foresight const& foresight = {});
    //! Stores what the calibration made of the runs up to a wave. Rank 0's arguments count.
    void store_analysis(int wave, std::vector<NamedArray> const& analysis);
    //! Marks the campaign as ended for the given reason.
    void end(std::string const& reason);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

//! Writes a new campaign file, with the plan of its first wave where that is given. \throws InputError when
//! it exists, FileError when it cannot be written
void create_campaign_file(std::filesystem::path const& file, CampaignInput const& input,
                          std::optional<WavePlan> const& first_wave = {});
//! The same with runs of another campaign file that hold: its first waves. \throws InputError where one is
//! not complete
void create_campaign_file(std::filesystem::path const& file, CampaignInput const& input,
                          std::vector<Wave> const& taken);
//! Reads a campaign file on one rank, without opening it for writing; without what campaign_reader.hpp reads
//! run by run. \throws InputError
Campaign read_campaign_file(std::filesystem::path const& file, Rigs const& rigs = rig::all_rigs());

//! One task of a Slurm job array: runs those of the last wave whose number is `task` modulo `tasks` and
//! leaves them beside the file; the next session gathers them. Several tasks may work at the same time.
//! Collective.
WaveEnd run_shards(MPI_Comm communicator, std::filesystem::path const& file, int task, int tasks,
                   SessionOptions const& options = {});

} // namespace demens::ensemble
