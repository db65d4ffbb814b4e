#pragma once

#include "app/command.hpp"

namespace demens::cli {

//! Adds the subcommand `rehearse` to `demens gap`.
void add_rehearse(CLI::App& gap, Action& action);

} // namespace demens::cli
