#pragma once

#include "ensemble/campaign.hpp"

#include <nlohmann/json.hpp>

namespace demens::report {

//! The measured curves of an experiment beside those of a run: points of both on the measured axis, and the
//! windows with the numbers of their targets.
nlohmann::json curves_beside(ensemble::CampaignInput const& input, std::size_t experiment,
                             ensemble::RunDetails const& details);
//! The photograph's bed beside the run's, on the photograph's raster: both masks as runs of light and dark
//! pixels in turns, row by row from the top, beginning with light; null where there is no photograph or
//! picture.
nlohmann::json picture_beside(ensemble::CampaignInput const& input, std::size_t experiment,
                              ensemble::RunDetails const& details);

} // namespace demens::report
