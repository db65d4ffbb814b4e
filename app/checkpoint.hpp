#pragma once

#include "demens/rig/programme/programme_run.hpp"
#include "ensemble/campaign.hpp"

#include <filesystem>

namespace demens::cli {

//! A run where a stage begins, as a file that knows whose it is: FOLDER/run-7-stage-2-discharge.checkpoint.
class Checkpoints
{
  public:
    //! Those of one run of a campaign.
    Checkpoints(ensemble::Campaign const& campaign, ensemble::RunRecord const& run)
        : input_(campaign.input.resolved_text()), run_(run.run)
    {
    }
    //! \return the file. \throws FileError
    std::filesystem::path write(std::filesystem::path const& folder, rig::RunState const& state,
                                std::string const& stage) const;
    //! \throws FileError, InputError for a file that is none, damaged, or of another run or campaign
    rig::RunState read(std::filesystem::path const& file) const;

  private:
    std::string input_; //!< the campaign's resolved input
    int run_;
};

} // namespace demens::cli
