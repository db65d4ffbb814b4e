#pragma once

#include "ensemble/status/campaign_status.hpp"

#include <string>

namespace demens::ensemble {

//! The status as one line of JSON; STATUS.md documents its keys. What is not known is null.
std::string status_json(CampaignStatus const& status);

} // namespace demens::ensemble
