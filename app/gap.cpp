// Where the calibrated model misses, and what it may lack.
#include "app/command.hpp"
#include "app/mpi_scope.hpp"
#include "app/new_campaign.hpp"
#include "app/rehearse.hpp"
#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/session.hpp"
#include "gap/campaign/diagnose.hpp"
#include "gap/campaign/plan_report.hpp"
#include "gap/campaign/report.hpp"
#include "gap/catalogue/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;

char const* sign_text(ensemble::EffectSign sign)
{
    switch (sign) {
    case ensemble::EffectSign::positive:
        return "+";
    case ensemble::EffectSign::negative:
        return "-";
    case ensemble::EffectSign::either:
        break;
    }
    return "+-";
}

int list_effects(std::string const& file)
{
    std::vector<std::string> possible;
    std::vector<gap::CandidateEffect> own;
    if (!file.empty()) {
        auto const input = ensemble::CampaignInput::from_file(file);
        for (auto const& candidate : gap::candidates_of(input)) {
            possible.push_back(candidate.effect.name);
            if (candidate.group == "own")
                own.push_back(candidate);
        }
    }
    std::string group;
    for (auto const& entry : gap::catalogue()) {
        if (!file.empty() && std::find(possible.begin(), possible.end(), entry.name) == possible.end())
            continue;
        if (group != word_for(entry.group))
            fmt::print("{}\n", group = word_for(entry.group));
        fmt::print("  {:<22}{}\n", entry.name, entry.doc);
        fmt::print("  {:<22}amplitude: {}, {}{:g} typical; changes {}\n", "", entry.amplitude,
                   sign_text(entry.sign), entry.typical, entry.keys);
    }
    for (auto const& candidate : own) {
        if (group != "own")
            fmt::print("{}\n", group = "own");
        fmt::print("  {:<22}{}; {}{:g} typical\n", candidate.effect.name, candidate.amplitude,
                   sign_text(candidate.effect.sign), candidate.effect.typical);
    }
    return success;
}

int show_gap(std::string const& file, bool as_json)
{
    auto const campaign = ensemble::read_campaign_file(file);
    if (as_json)
        fmt::print("{}\n", gap::gap_document(campaign).dump(2));
    else
        fmt::print("{}", gap::gap_text(campaign));
    return success;
}

int plan_ahead(std::string const& toml, std::string const& output, bool as_json)
{
    fs::path file = output;
    if (file.empty())
        file = fs::path(toml).replace_extension(".plan.h5");
    ensemble::on_root(MPI_COMM_WORLD, [&] { make_or_accept(toml, file); });
    ensemble::Session session(MPI_COMM_WORLD, file);
    if (gap::plan_ahead(session) == ensemble::WaveEnd::drained) {
        if (ensemble::rank_of(MPI_COMM_WORLD) == 0)
            fmt::print("stopped as asked; nothing is lost, go on with the same command\n");
        return drained;
    }
    if (ensemble::rank_of(MPI_COMM_WORLD) == 0)
        fmt::print("{}", as_json ? gap::plan_document(session.campaign()).dump(2) + "\n"
                                 : gap::plan_text(session.campaign()));
    return success;
}

} // namespace

void add_effects(CLI::App& program, Action& action)
{
    auto file = std::make_shared<std::string>();
    auto* command = program.add_subcommand(
        "effects", "effects that a model may lack, with what they change; of a campaign: those it allows");
    command->add_option("FILE.toml", *file, "campaign as its author writes it; none: the whole catalogue");
    command->callback([file, &action] { action = [file] { return list_effects(*file); }; });
}

void add_gap(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file, toml, output;
        bool json = false;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "gap",
        "where the calibrated model misses the measurements, which effect it lacks, how far that goes");
    command->require_subcommand(0, 1);
    command->add_option("FILE.h5", options->file, "campaign file with [gap]; may be running");
    command->add_flag("--json", options->json, "the same as JSON");
    auto* plan = command->add_subcommand(
        "plan",
        "before anything is measured: what these experiments can tell apart; under mpirun on all ranks");
    plan->add_option("FILE.toml", options->toml, "campaign as its author writes it")->required();
    plan->add_flag("--json", options->json, "the same as JSON");
    plan->add_option("-o,--output", options->output, "file for its runs; default FILE.plan.h5");
    plan->callback([options, &action] {
        action = [options] {
            return on_all_ranks([&] { return plan_ahead(options->toml, options->output, options->json); });
        };
    });
    add_rehearse(*command, action);
    command->callback([options, command, &action] {
        if (!command->get_subcommands().empty())
            return;
        if (options->file.empty())
            throw CLI::RequiredError("FILE.h5");
        action = [options] { return show_gap(options->file, options->json); };
    });
}

} // namespace demens::cli
