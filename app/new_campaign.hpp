#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <filesystem>

namespace demens::cli {

//! `drawdown.toml` -> `drawdown.h5`
std::filesystem::path default_campaign_file(std::filesystem::path const& toml);

//! Makes the campaign file of a TOML file, or accepts the one that is there when it was made of the same
//! input. Tells what the plan of a new one is. \throws InputError when it was made of another
void make_or_accept(std::filesystem::path const& toml, std::filesystem::path const& campaign_file);

//! What is said where the TOML file beside a campaign is not what that was made of; empty where it is, or
//! none is there.
std::string other_input_text(std::filesystem::path const& campaign_file,
                             ensemble::CampaignInput const& stored);

} // namespace demens::cli
