#pragma once

#include "ensemble/campaign.hpp"

#include <filesystem>
#include <string>

namespace demens::ensemble {

//! Text for `demens status FILE`: waves, runs done, running and failed, best fit so far, time left. Reads
//! only, and is safe while a session works on the file. \throws InputError
std::string status_text(std::filesystem::path const& file, Rigs const& rigs = rig::all_rigs());

//! Its part on the best run, and what the targets tell of the factors.
std::string best_fit_text(Campaign const& campaign);

} // namespace demens::ensemble
