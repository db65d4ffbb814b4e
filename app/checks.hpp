#pragma once

#include <CLI/CLI.hpp>

namespace demens::cli {

//! A number above 0; what is said of another is for people, where the one of CLI11 has all digits of the
//! largest number.
CLI::Validator above_zero();

} // namespace demens::cli
