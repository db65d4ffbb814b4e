#pragma once

#include "ensemble/file/hdf5.hpp"
#include "ensemble/reuse/rows_that_hold.hpp"
#include "ensemble/reuse/taken_waves.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace demens::ensemble {

//! A campaign file together with the runs of its waves in progress that are finished beside it.
class CampaignWithShards
{
  public:
    //! \throws InputError
    explicit CampaignWithShards(std::filesystem::path file, Rigs const& rigs = rig::all_rigs());

    std::filesystem::path const& file() const { return file_; }
    //! Runs that are finished beside the file have their results in it.
    Campaign const& campaign() const { return campaign_; }
    //! Whether the file itself has waves whose runs are not all in it.
    bool is_in_progress() const { return is_in_progress_; }
    //! \param run one that has ended
    RunDetails details(RunRecord const& run) const;

  private:
    std::filesystem::path file_;
    Campaign campaign_;
    bool is_in_progress_;
    hdf5::File opened_;
    std::map<int, RunDetails> beside_; //!< by run
};

//! How much of a campaign file stays as it is.
enum class Keeping
{
    whole_file, //!< all runs hold where they are
    runs        //!< those that hold are written anew
};

//! A campaign that goes on with another input.
struct ExtensionPlan
{
    CampaignInput input;
    Extension extension;
    Keeping keeping = Keeping::whole_file;
    std::vector<KeptWave> kept = {};           //!< where not the whole file is kept
    std::vector<std::string> differences = {}; //!< why other runs do not hold
    int ended = 0, held = 0;                   //!< runs of the campaign that have ended; those that are kept

    //! As it is with what is kept, before anything more is planned.
    Campaign campaign_of(Campaign const& there) const;
};

//! \param runs more ones to be made, whatever the goals; 0: as [stop] says
//! \param source what runs that are written anew are marked with
//! \param widest whether the whole file may be kept
ExtensionPlan plan_extension(CampaignInput const& input, int runs, CampaignWithShards const& there,
                             std::string const& source, Keeping widest = Keeping::whole_file);

//! Writes what is planned and the first waves that follow, all at once or not at all. Nobody may work on
//! either file. Where a file is replaced by one that keeps not all of it, it stays under another name.
//! \return that name; empty where there is none \throws FileError
std::filesystem::path write_extension(std::filesystem::path const& file, CampaignWithShards const& there,
                                      ExtensionPlan const& plan, std::vector<Wave> const& waves);

//! Where a file stays of which an extension does not keep all: `campaign.before-1.h5`, the first that is
//! free.
std::filesystem::path name_of_kept_file(std::filesystem::path const& file);

} // namespace demens::ensemble
