#include "app/command.hpp"
#include "app/log.hpp"
#include "demens/base/error.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/version.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace {

using namespace demens;

constexpr char const* footer = R"(
a campaign:
  demens try FILE.toml --plan           what it would simulate; without --plan: once, at the base values
  demens new FILE.toml                  check it and write FILE.h5
  demens plan FILE.h5                   how many ranks, how long, how much memory
  mpirun -n N demens FILE.h5            run it, or go on with it; safe to kill and repeat
  mpirun -n N demens FILE.toml          both in one
  demens status FILE.h5                 how far it is
  demens gap FILE.h5                    where the calibrated model misses and what it lacks
  demens report FILE.h5                 one HTML page with the plots
  demens export FILE.h5                 runs, curves and the best point as CSV and TOML
  demens replay FILE.h5 --run 17 --frames out/
  demens redo FILE.h5 --run 17          have a run run again; drop: take it out of the fits
  demens extend FILE.h5 --runs 60       go on with an ended campaign; --continue NEW.toml: with another input

exit codes:
  0   done
  2   bad input: nothing was started, nothing was changed
  75  stopped as asked: run the same command again to go on, nothing is lost. Ctrl-C (SIGINT)
      and SIGTERM give up the runs in progress, SIGUSR1 lets them end (for 240 s at most);
      mpirun returns 75 after SIGUSR1, and a code of its own (1) after Ctrl-C and SIGTERM
  1   anything else, e.g. a full disk, or a campaign none of whose runs finish
)";

//! Whether a word is that of a file, or is meant to be.
bool is_of_campaign(std::string const& word)
{
    auto const extension = std::filesystem::path(word).extension();
    return extension == ".toml" || extension == ".h5" || std::filesystem::exists(word);
}

//! \throws InputError that names the subcommand that is meant
[[noreturn]] void suggest_subcommand(CLI::App const& program, std::string const& word)
{
    std::vector<std::string> names;
    for (auto const* command : program.get_subcommands([](auto const*) { return true; }))
        names.push_back(command->get_name());
    throw InputError(fmt::format("\"{}\" is neither a subcommand nor a file; {}", word,
                                 ensemble::input::suggestion(word, names)));
}

//! The subcommand that is being given, as deep as it is nested.
CLI::App const& innermost(CLI::App const& program)
{
    auto const parsed = program.get_subcommands();
    return parsed.empty() ? program : innermost(*parsed.front());
}

//! \throws InputError where one of the words that are left over is no option
void refuse_unknown_option(CLI::App const& program, std::vector<std::string> const& left_over)
{
    auto const& command = innermost(program);
    std::vector<std::string> names;
    for (auto const* option : command.get_options())
        for (auto const& name : option->get_lnames())
            names.push_back("--" + name);
    for (auto const& given : left_over)
        if (auto const word = given.substr(0, given.find('=')); word.starts_with("--"))
            throw InputError(fmt::format("{} is no option of {}; {}", word,
                                         &command == &program ? "demens without a subcommand"
                                                              : "\"" + command.get_name() + "\"",
                                         ensemble::input::suggestion(word, names)));
}

int do_what_is_asked(int argc, char** argv)
{
    CLI::App program{"Calibrates discrete element models of granular materials from bulk experiments.",
                     "demens"};
    program.set_version_flag("--version",
                             fmt::format("demens {} ({})", ensemble::program_version, ensemble::git_commit));
    program.require_subcommand(0, 1);
    cli::Action action;
    std::string file, log_level = cli::usual_log_level;
    auto* to_run = program.add_option("FILE", file, "campaign file or TOML file to run");
    cli::add_log_level(program, log_level)->needs(to_run);
    cli::begin_log(log_level);
    cli::add_new(program, action);
    cli::add_try(program, action);
    cli::add_plan(program, action);
    cli::add_run(program, action);
    cli::add_status(program, action);
    cli::add_redo(program, action);
    cli::add_drop(program, action);
    cli::add_extend(program, action);
    cli::add_report(program, action);
    cli::add_export(program, action);
    cli::add_replay(program, action);
    cli::add_rigs(program, action);
    cli::add_laws(program, action);
    cli::add_keys(program, action);
    cli::add_fit(program, action);
    cli::add_scale(program, action);
    cli::add_observe(program, action);
    cli::add_effects(program, action);
    cli::add_gap(program, action);
    cli::add_shell_help(program, action);
    // Of the program alone: a subcommand takes over what stands there when it is added.
    program.footer(footer);
    try {
        program.parse(argc, argv);
    } catch (CLI::ExtrasError const& error) {
        // A misspelt subcommand is taken for the file, and its arguments are left over.
        if (program.get_subcommands().empty() && !is_of_campaign(file))
            suggest_subcommand(program, file);
        refuse_unknown_option(program, program.remaining(true));
        return program.exit(error) == 0 ? cli::success : cli::bad_input;
    } catch (CLI::ParseError const& error) {
        if (error.get_exit_code() != 0) // else it asks for help
            refuse_unknown_option(program, program.remaining(true));
        return program.exit(error) == 0 ? cli::success : cli::bad_input;
    }

    if (action)
        return action();
    if (!file.empty() && !is_of_campaign(file))
        suggest_subcommand(program, file);
    if (!file.empty())
        return cli::run_campaign(file, log_level);
    fmt::print("{}", program.help());
    return cli::bad_input;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return do_what_is_asked(argc, argv);
    } catch (InputError const& error) {
        std::fprintf(stderr, "demens: error: %s\n", error.what());
        return cli::bad_input;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "demens: error: %s\n", error.what());
        return cli::failure;
    }
}
