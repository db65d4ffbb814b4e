#pragma once

#include "ensemble/campaign.hpp"
#include "report/analysis.hpp"

#include <nlohmann/json.hpp>

namespace demens::report {

//! Adds to the optimum how far the best run is off in words, whether the targets are missed, which intervals
//! are told, and the sets that the targets allow.
void add_fit_in_words(nlohmann::json& optimum, ensemble::Campaign const& campaign, Analysis const& analysis);

//! Every value of the model that is in use at the best point, with path and units; null without a best run.
nlohmann::json values_at_best(ensemble::Campaign const& campaign, Analysis const& analysis);

//! Best run, estimate and intervals after each wave that was analysed.
nlohmann::json progress_of(ensemble::Campaign const& campaign);

} // namespace demens::report
