#include "app/command.hpp"
#include "demens/base/error.hpp"
#include "ensemble/reopen.hpp"
#include "ensemble/session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace demens::cli {
namespace {

using ensemble::Fate;

struct Selection
{
    std::string file, status, reason;
    std::vector<int> runs;
};

//! Runs with a status, by its name.
std::vector<int> runs_with(ensemble::Campaign const& campaign, std::string const& status,
                           std::string const& file)
{
    std::vector<int> runs;
    std::set<std::string> present;
    for (auto const& run : campaign.all_runs()) {
        if (rig::name_of(run.status) == status)
            runs.push_back(run.run);
        present.insert(rig::name_of(run.status));
    }
    if (runs.empty())
        throw InputError(
            fmt::format("{}: no run in it has the status \"{}\"; there are {}", file, status,
                        present.empty() ? "no runs" : fmt::format("{}", fmt::join(present, ", "))));
    return runs;
}

int take_back(Selection const& selection, Fate fate)
{
    auto runs = selection.runs;
    if (!selection.status.empty()) {
        auto const more =
            runs_with(ensemble::read_campaign_file(selection.file), selection.status, selection.file);
        runs.insert(runs.end(), more.begin(), more.end());
    }
    if (runs.empty())
        throw InputError("say which runs: --run N, or --status WORD for all that ended so");
    ensemble::take_back(selection.file, runs, fate, selection.reason);
    auto const count = std::set<int>(runs.begin(), runs.end()).size();
    fmt::print("{} run{} {}; go on with: mpirun -n N demens {}\n", count, count == 1 ? "" : "s",
               fate == Fate::redo ? "will be run again" : "dropped", selection.file);
    return success;
}

CLI::App* add(CLI::App& program, Action& action, char const* name, char const* help, Fate fate,
              std::shared_ptr<Selection> const& selection)
{
    auto* command = program.add_subcommand(name, help);
    command->add_option("FILE.h5", selection->file, "campaign file; nobody may work on it")->required();
    command->add_option("--run", selection->runs, "numbers of runs, as in the report");
    command->add_option("--status", selection->status,
                        "all runs that ended so in complete waves, e.g. \"timed out\" or quarantined");
    command->callback([=, &action] { action = [=] { return take_back(*selection, fate); }; });
    return command;
}

} // namespace

void add_redo(CLI::App& program, Action& action)
{
    add(program, action, "redo", "have runs of a campaign run again", Fate::redo,
        std::make_shared<Selection>());
}

void add_drop(CLI::App& program, Action& action)
{
    auto selection = std::make_shared<Selection>();
    add(program, action, "drop",
        "take runs out of a campaign: no longer fitted, not counted as failed; undone by redo", Fate::drop,
        selection)
        ->add_option("--because", selection->reason, "kept with the runs");
}

} // namespace demens::cli
