#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace demens::cli {

//! The word of `--log-level` that holds where none is given.
inline constexpr char const* usual_log_level = "info";

//! Adds `--log-level`. \param level receives the word
CLI::Option* add_log_level(CLI::App& command, std::string& level);

//! From now on what is told goes to the error stream; with the time of day and the rank where single runs are
//! told (`debug`). \param level one of the words
void begin_log(std::string const& level, int rank = 0);

} // namespace demens::cli
