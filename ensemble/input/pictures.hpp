#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! Reads `target.picture = { file = "drum.png", ... }` of the last experiment in `base`: has its rig keep its
//! picture, adds the responses and the targets. \return what is said of it
std::vector<std::string> read_picture_target(InputTable const& table, InputTable const& experiment_table,
                                             FileSource const& source, BaseInput& base,
                                             Experiment& experiment);

} // namespace demens::ensemble::input
