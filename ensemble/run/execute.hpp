#pragma once

#include "ensemble/file/parts.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace demens::ensemble {

//! Simulates, and compares with the measured curves of the experiment. \throws rig::RunInterrupted
rig::RunResult run_experiment(Experiment const& experiment, rig::RunInput const& input,
                              rig::RunHooks const& hooks);

//! Simulates one planned run. Whatever goes wrong in it is its status and reason. \throws rig::RunInterrupted
FinishedRun execute(CampaignInput const& input, RunRecord const& plan, rig::RunHooks const& hooks);

//! Of a planned run that has given this: with its comparisons, or what is wrong with it.
FinishedRun finished_run(CampaignInput const& input, RunRecord const& plan, rig::RunResult result,
                         double wall_time);
//! What a planned run needs to know.
rig::RunInput run_input_of(CampaignInput const& input, RunRecord const& plan);

//! The runs of a wave, numbered after all runs of the campaign. \throws InputError for a plan that does not
//! fit the campaign
Wave plan_runs(Campaign const& campaign, WavePlan const& plan);

} // namespace demens::ensemble
