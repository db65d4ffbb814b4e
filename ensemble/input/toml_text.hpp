#pragma once

#include "demens/base/options.hpp"

#include <string>

namespace demens::ensemble::input {

//! A TOML string.
std::string quoted(std::string const& text);
//! The shortest TOML number with a fraction or an exponent that reads back as the same double.
std::string number_text(double value);
//! A value of any kind.
std::string option_text(OptionValue const& value);

} // namespace demens::ensemble::input
