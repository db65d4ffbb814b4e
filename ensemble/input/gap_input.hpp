#pragma once

#include "ensemble/input/base_input.hpp"

#include <optional>
#include <vector>

namespace demens::ensemble::input {

//! Reads `[gap]` where it is there; the experiments that it names get their roles. \throws InputError, also
//! for a target without a value that must have one
std::optional<GapOptions> read_gap(InputTable const& file, std::vector<Experiment>& experiments);

} // namespace demens::ensemble::input
