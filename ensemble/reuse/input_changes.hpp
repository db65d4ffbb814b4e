#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <string>
#include <vector>

namespace demens::ensemble {

//! What is different in another input of a campaign, one line each, e.g. `stop.runs: 100, now 160` or
//! `experiment.bench.target.angle_deg.value: 30.0, now 31.5`; defaults count as if they were written.
std::vector<std::string> input_changes(CampaignInput const& before, CampaignInput const& now);

//! Whether another input asks for the same, however it is written.
bool is_same_input(CampaignInput const& before, CampaignInput const& now);

//! Whether what the calibration made of runs would be the same: none of these changes is of anything but how
//! long, and with which means, is searched.
bool keeps_analyses(std::vector<std::string> const& changes);

} // namespace demens::ensemble
