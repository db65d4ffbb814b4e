#pragma once

#include "ensemble/input/input_table.hpp"

namespace demens::ensemble::input {

//! \throws InputError
void refuse_old_words(InputTable const& solver);
//! Moves from `[solver]` to `[search]` what stands there now, unless it is there already.
void understand_old_words(toml::table& file);

} // namespace demens::ensemble::input
