#pragma once

#include "gap/campaign/closure.hpp"
#include "gap/campaign/diagnosis.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demens::gap {

// What the report as text and as JSON have in common.

//! Whether a campaign asks for a diagnosis, not for predictions alone.
bool diagnoses(ensemble::Campaign const& campaign);
//! \throws InputError for a campaign that is not ready, with what to do
void require_signatures(ensemble::Campaign const& campaign);
//! What a hypothesis says: "none", "unknown", or its effects.
std::vector<std::string> names_of(Hypothesis const& hypothesis, std::vector<Signature> const& effects);
std::vector<std::string> names_of(std::vector<int> const& places, std::vector<Signature> const& effects);
//! What is said of causes once decoys have been tried.
Attribution judged(Diagnosis const& found, std::optional<CampaignClosure> const& closure);

} // namespace demens::gap
