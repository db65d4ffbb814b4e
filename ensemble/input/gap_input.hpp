#pragma once

#include "ensemble/input/base_input.hpp"

#include <vector>

namespace demens::ensemble::input {

//! Reads `[gap]`; the experiments that it holds out get that role. \throws InputError
GapOptions read_gap(InputTable const& table, std::vector<Experiment>& experiments);

} // namespace demens::ensemble::input
