#pragma once

#include "ensemble/input/base_input.hpp"

#include <string>

namespace demens::ensemble::input {

//! The campaign as TOML with every default written out and every key explained; reading it gives the same
//! campaign.
std::string resolved_text(CampaignInput const& input, BaseInput const& base);

} // namespace demens::ensemble::input
