#pragma once

#include "ensemble/campaign.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace demens::gap {

//! Where the calibrated model misses, which effect it lacks, how far that goes, what was assumed: one screen.
//! \throws InputError where nothing can be diagnosed
std::string gap_text(ensemble::Campaign const& campaign);
//! The same as JSON, with the signatures.
nlohmann::json gap_document(ensemble::Campaign const& campaign);
//! Whether the diagnosis of a campaign has begun.
bool has_diagnosis(ensemble::Campaign const& campaign);

} // namespace demens::gap
