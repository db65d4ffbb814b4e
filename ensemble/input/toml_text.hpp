#pragma once

#include <string>

namespace demens::ensemble::input {

//! A TOML string.
std::string quoted(std::string const& text);
//! The shortest TOML number with a fraction or an exponent that reads back as the same double.
std::string number_text(double value);

} // namespace demens::ensemble::input
