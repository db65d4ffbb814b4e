#pragma once

#include "ensemble/campaign.hpp"

#include <filesystem>
#include <memory>

namespace demens::ensemble {

//! A campaign file, looked at as a whole once and then held open to read many runs of it, by one process. A
//! session may go on with the file meanwhile: what is read is what was there at the beginning.
class CampaignReader
{
  public:
    //! \throws InputError where it is no campaign, or damaged
    explicit CampaignReader(std::filesystem::path file, Rigs const& rigs = rig::all_rigs());
    CampaignReader(CampaignReader&&) noexcept;
    ~CampaignReader();

    Campaign const& campaign() const;
    //! Snapshots, series and profiles. \throws InputError when the campaign has no such run or it has not
    //! been simulated
    RunDetails details_of(int run) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace demens::ensemble
