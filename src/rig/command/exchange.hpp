#pragma once

#include "demens/rig/rig.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace demens::rig::command {

//! Names and values that a program is given.
using Parameters = std::map<std::string, double>;

//! Parameters and seed as a JSON object.
std::string parameters_json(Parameters const& parameters, std::uint64_t seed);
//! A text with every ${NAME} replaced by its value, ${seed} too. \throws InputError for another name
std::string filled(std::string const& text, Parameters const& parameters, std::uint64_t seed);

//! The numbers of those names in a JSON object or a CSV table of one row, by the end of the file's name; NaN
//! where there is none. \throws InputError where the file cannot be read
std::vector<double> read_results(std::filesystem::path const& file, std::vector<std::string> const& names);
//! A table of curves over its first column; `name [unit]` tells a unit. \throws InputError
Series read_series(std::filesystem::path const& file);

//! The last line of a file that is not empty, at most so long; empty: there is none.
std::string last_line(std::filesystem::path const& file, std::size_t longest);

} // namespace demens::rig::command
