#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace demens::cli {

//! How the program ends; part of what users and scripts rely on.
enum ExitCode : int
{
    success = 0,
    failure = 1,   //!< anything that is not one of the others
    bad_input = 2, //!< nothing was started and nothing was changed
    drained = 75   //!< asked to stop; run again to go on
};

//! What the command line asks for. \return exit code
using Action = std::function<int()>;

// Each adds one subcommand, which sets the action when it is named.
void add_new(CLI::App& program, Action& action);
void add_try(CLI::App& program, Action& action);
void add_plan(CLI::App& program, Action& action);
void add_run(CLI::App& program, Action& action);
void add_status(CLI::App& program, Action& action);
void add_redo(CLI::App& program, Action& action);
void add_drop(CLI::App& program, Action& action);
void add_extend(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_replay(CLI::App& program, Action& action);
void add_rigs(CLI::App& program, Action& action);
void add_laws(CLI::App& program, Action& action);
void add_keys(CLI::App& program, Action& action);
void add_fit(CLI::App& program, Action& action);
void add_scale(CLI::App& program, Action& action);
void add_observe(CLI::App& program, Action& action);
void add_effects(CLI::App& program, Action& action);
void add_gap(CLI::App& program, Action& action);
void add_shell_help(CLI::App& program, Action& action);

//! Runs a campaign file, or first makes one of a TOML file, on all ranks. \param log_level word of
//! `app/log.hpp` \return exit code, the same on all ranks
int run_campaign(std::string const& file, std::string const& log_level);

} // namespace demens::cli
