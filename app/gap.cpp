// Where the calibrated model misses, and what it may lack.
#include "app/command.hpp"
#include "app/mpi_scope.hpp"
#include "app/new_campaign.hpp"
#include "app/rehearse.hpp"
#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/session.hpp"
#include "gap/campaign/campaign_evidence.hpp"
#include "gap/campaign/diagnose.hpp"
#include "gap/campaign/plan_report.hpp"
#include "gap/campaign/report.hpp"
#include "gap/catalogue/catalogue.hpp"
#include "gap/statistics/form_floor.hpp"
#include "gap/table/table_report.hpp"
#include "tao_calib/solver/pounders.hpp"

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

int plan_ahead(std::string const& toml, std::string const& output, int twins, bool as_json)
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
        fmt::print("{}", as_json ? gap::plan_document(session.campaign(), twins).dump(2) + "\n"
                                 : gap::plan_text(session.campaign(), twins));
    return success;
}

int make_bank(std::string const& toml, std::string const& output, int points_per_effect)
{
    fs::path const file = output.empty() ? fs::path(toml).replace_extension(".h5") : fs::path(output);
    ensemble::on_root(MPI_COMM_WORLD, [&] { make_or_accept(toml, file); });
    ensemble::Session session(MPI_COMM_WORLD, file);
    bool const is_root = ensemble::rank_of(MPI_COMM_WORLD) == 0;
    if (gap::fill_bank(session, points_per_effect) == ensemble::WaveEnd::drained) {
        if (is_root)
            fmt::print("stopped as asked; nothing is lost, go on with the same command\n");
        return drained;
    }
    if (is_root)
        fmt::print("{0}: {1} runs; a campaign of the same rigs takes them over with [run] bank = \"{0}\"\n",
                   file.string(), session.campaign().runs_planned());
    return success;
}

//! By one rank.
int show_table(std::string const& toml, bool as_json)
{
    MpiOnOneRank const mpi;
    tao_calib::PetscSession const petsc;
    auto const measured = gap::read_measured(toml);
    auto const found = gap::table_gap(measured, tao_calib::Pounders(petsc));
    fmt::print("{}", as_json ? gap::table_gap_document(measured, found).dump(2) + "\n"
                             : gap::table_gap_text(measured, found));
    return success;
}

int show_floor(std::vector<std::string> const& files)
{
    std::vector<gap::Evidence> cases;
    for (auto const& file : files)
        try {
            cases.push_back(
                gap::evidence_of(ensemble::read_campaign_file(file), gap::Centre::estimate).evidence);
        } catch (InputError const& error) {
            throw InputError(fmt::format("{}: {}", file, error.what()));
        }
    auto const floor = gap::estimate_form_floor(std::move(cases));
    fmt::print(
        "form_floor = {:.4f} # of a response, by {} campaigns in which nothing is missing; at most {:.4f} at "
        "95 %, which is safer against false alarms\n",
        floor.most_likely, files.size(), floor.upper);
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
        std::vector<std::string> files;
        bool json = false;
        int points_per_effect = 8, twins = 200;
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
    plan->add_option("--twins", options->twins, "of each cause that are diagnosed")
        ->check(CLI::Range(20, 100000))
        ->capture_default_str();
    plan->callback([options, &action] {
        action = [options] {
            return on_all_ranks(
                [&] { return plan_ahead(options->toml, options->output, options->twins, options->json); });
        };
    });
    auto* bank = command->add_subcommand(
        "bank", "runs of the base model and of every effect all over the factors, for all campaigns of these "
                "rigs; needs no measured value; under mpirun on all ranks");
    bank->add_option("FILE.toml", options->toml,
                     "campaign as its author writes it; [design] says how many "
                     "points of the base model")
        ->required();
    bank->add_option("-o,--output", options->output, "campaign file; default FILE.h5");
    bank->add_option("--points-per-effect", options->points_per_effect, "on each experiment that it changes")
        ->check(CLI::Range(1, 10000));
    bank->callback([options, &action] {
        action = [options] {
            return on_all_ranks(
                [&] { return make_bank(options->toml, options->output, options->points_per_effect); });
        };
    });
    auto* table = command->add_subcommand(
        "table", "where a table of any program's runs contradicts measurements at several points");
    table->add_option("FILE.toml", options->toml, "as for `demens fit`, with [fit] measured")->required();
    table->add_flag("--json", options->json, "the same as JSON");
    table->callback(
        [options, &action] { action = [options] { return show_table(options->toml, options->json); }; });
    auto* floor = command->add_subcommand(
        "floor", "form floor under which campaigns in which nothing is missing are most probable");
    floor->add_option("FILE.h5", options->files, "calibrated campaigns with [gap]")->required();
    floor->callback([options, &action] { action = [options] { return show_floor(options->files); }; });
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
