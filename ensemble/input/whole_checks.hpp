#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! What sections must satisfy together: design and factors, targets, budget. \throws InputError
void check_sections(InputTable const& file, CampaignInput const& input);
//! What a rig has against a run, or against sharing it among so many ranks. \throws InputError
void check_run(rig::RigInfo const& rig, rig::RunInput const& run, int ranks);
//! Ranks that share a run, where the campaign leaves it open: 10,000 particles of the largest experiment
//! each, at its base values, and no more than every rig can be shared by.
int ranks_that_pay(CampaignInput const& input, BaseInput const& base);
//! Lets every rig check the base input and the corners of the factors' ranges, so that no run can be refused
//! later for what its author wrote. \throws InputError
void check_rigs(CampaignInput const& input, BaseInput const& base,
                std::vector<InputTable> const& experiment_tables);

} // namespace demens::ensemble::input
