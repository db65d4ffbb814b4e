#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/run/execute.hpp"

#include <string>

namespace demens::cli {

//! The run of that number. \param file names the campaign in errors \throws InputError where it is not there,
//! or was simulated for another campaign
ensemble::RunRecord run_to_simulate(ensemble::Campaign const& campaign, std::string const& file, int run);

//! Simulates it once more. \throws rig::RunInterrupted
rig::RunResult simulate_again(ensemble::Campaign const& campaign, ensemble::RunRecord const& run,
                              rig::RunHooks const& hooks);

} // namespace demens::cli
