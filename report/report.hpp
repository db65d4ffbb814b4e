#pragma once

#include "ensemble/status/campaign_status.hpp"
#include "report/extras.hpp"

#include <filesystem>

namespace demens::report {

//! Writes the report of a campaign, finished or still running, as one HTML file that needs no network.
//! \throws InputError when the campaign cannot be read or the page cannot be written.
void write_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html,
                  Extras const& extras = {});
//! The same of a campaign that is worked on: the page says how far it is and loads itself again.
//! \param reload_every [s]
void write_live_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html,
                       ensemble::CampaignStatus const& status, double reload_every);

} // namespace demens::report
