#pragma once

#include "ensemble/campaign.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace demens::gap {

//! What the experiments of a campaign can tell, before anything is measured: how much of each effect
//! recalibration hides, which effects look alike, the smallest amplitudes that show. \throws InputError where
//! its runs are not there \param twins of each cause that are diagnosed
std::string plan_text(ensemble::Campaign const& campaign, int twins);
//! The same as JSON, with the whole confusion matrix.
nlohmann::json plan_document(ensemble::Campaign const& campaign, int twins);

} // namespace demens::gap
