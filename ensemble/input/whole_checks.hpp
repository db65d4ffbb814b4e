#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! What sections must satisfy together: design and factors, targets, budget. \throws InputError
void check_sections(InputTable const& file, CampaignInput const& input);
//! Lets every rig check the base input and the corners of the factors' ranges, so that no run can be refused
//! later for what its author wrote. \throws InputError
void check_rigs(CampaignInput const& input, BaseInput const& base,
                std::vector<InputTable> const& experiment_tables);

} // namespace demens::ensemble::input
