#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/input_table.hpp"

namespace demens::ensemble::input {

//! The list `combinations` of [objective]: `SUM = TARGET`, sums of responses that have targets, named
//! `RESPONSE` or `EXPERIMENT.RESPONSE`. \throws InputError
std::vector<TargetCombination> read_combinations(InputTable const& table,
                                                 std::vector<Experiment> const& experiments);

} // namespace demens::ensemble::input
