#pragma once

#include "ensemble/input/base_input.hpp"

#include <string>
#include <vector>

namespace demens::ensemble::input {

//! Reads `[[effect]]`. \throws InputError for a path that names nothing, or a value that it cannot have
std::vector<Effect> read_effects(InputTable const& file, BaseInput const& base,
                                 std::vector<Experiment> const& experiments);
//! Changes the values that they name, one after the other. \throws InputError for what a value cannot be
void apply(std::vector<Override> const& overrides, BaseInput& base,
           std::vector<Experiment> const& experiments);

} // namespace demens::ensemble::input
