#pragma once

#include "ensemble/status/campaign_status.hpp"

#include <string>

namespace demens::ensemble {

//! What `demens status FILE` prints: waves, runs done, running and failed with reasons, best fit so far, time
//! left.
std::string status_text(CampaignStatus const& status);
//! Its part on the best run, and what the targets tell of the factors.
std::string best_fit_text(std::optional<BestFit> const& best);

} // namespace demens::ensemble
