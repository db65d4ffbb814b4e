#pragma once

#include "demens/base/options.hpp"

#include <string>

namespace demens::ensemble::input {

//! The range of an option ("at least 0 and at most 1"); empty when any number is allowed.
std::string range_text(OptionSpec const& spec);
//! What is wrong with a number for an option ("must be at least 0"); empty when it is allowed.
std::string range_complaint(OptionSpec const& spec, double value);

} // namespace demens::ensemble::input
