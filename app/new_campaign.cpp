#include "app/new_campaign.hpp"

#include "app/command.hpp"
#include "demens/base/error.hpp"
#include "demens/base/text/shell.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/reuse/input_changes.hpp"
#include "ensemble/reuse/result_table.hpp"
#include "ensemble/run/wave_runner.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/lock.hpp"
#include "gap/campaign/next_wave.hpp"
#include "tao_calib/design/design.hpp"
#include "tao_calib/wave/plan.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <optional>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;
using ensemble::CampaignInput;

enum class IfExists
{
    refuse,
    replace
};

//! A campaign that is right, with its design, and what is to be told of it once it is accepted.
struct Checked
{
    CampaignInput input;
    std::string plan;
    std::vector<ensemble::Wave> taken = {}; //!< of its bank
};

//! What is to be told of the diagnosis. \throws InputError
std::vector<std::string> gap_lines(fs::path const& toml, CampaignInput const& input)
{
    try {
        return gap::announcement(input);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: {}", toml.string(), error.what()));
    }
}

//! What holds of the bank, which stands where the TOML file says. \throws InputError
ensemble::Taken take_over(fs::path const& toml, CampaignInput const& input)
{
    try {
        return ensemble::taken_from_bank(input, toml.parent_path() / input.run.bank);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: {}", toml.string(), error.what()));
    }
}

//! Reads a TOML file, plans its design and asks for the warnings: whatever is wrong is found before a word is
//! printed.
Checked read_checked(fs::path const& toml, std::vector<ensemble::ResultFile> const& results = {})
{
    Checked checked{CampaignInput::from_file(toml), {}, {}};
    auto const& input = checked.input;
    tao_calib::Design design;
    try {
        design = tao_calib::plan_design(input.design, input.factors, input.constraints, input.seed);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: {}", toml.string(), error.what()));
    }
    int runs_per_point = 0;
    for (auto const& experiment : input.experiments)
        if (experiment.role == ensemble::ExperimentRole::calibrate)
            runs_per_point += experiment.replicates;
    auto const runs = design.points.rows() * runs_per_point;
    if (runs > input.stop.runs)
        throw InputError(
            fmt::format("{}: the design has {} points and needs {} runs, but [stop] runs = {}; raise it or "
                        "choose a smaller design",
                        toml.string(), design.points.rows(), runs, input.stop.runs));
    auto const to = std::back_inserter(checked.plan);
    fmt::format_to(to, "{}: {} factors, {} experiments; the design has {} points, {} runs\n", input.name,
                   input.factors.size(), input.experiments.size(), design.points.rows(), runs);
    for (auto const& warning : input.warnings())
        fmt::format_to(to, "  warning: {}\n", warning);
    for (auto const& note : input.notes())
        fmt::format_to(to, "  {}\n", note);
    for (auto const& note : design.notes)
        fmt::format_to(to, "  {}\n", note);
    if (input.gap)
        for (auto const& line : gap_lines(toml, input))
            fmt::format_to(to, "  {}\n", line);
    if (!input.run.bank.empty() && !results.empty())
        throw InputError(
            fmt::format("{}: run.bank = \"{}\" does not go with --results", toml.string(), input.run.bank));
    if (!input.run.bank.empty() || !results.empty()) {
        auto [waves, lines] =
            results.empty() ? take_over(toml, input) : ensemble::taken_from_tables(input, results);
        checked.taken = std::move(waves);
        for (auto const& line : lines)
            fmt::format_to(to, "  {}\n", line);
    }
    return checked;
}

//! A campaign file that holds the plan of its first wave, or what it has taken over.
void create(fs::path const& file, Checked const& checked)
{
    auto const& input = checked.input;
    if (!checked.taken.empty()) {
        ensemble::create_campaign_file(file, input, checked.taken);
        return;
    }
    auto const first = tao_calib::first_wave(input);
    std::optional<ensemble::WavePlan> plan;
    if (first.kind == tao_calib::NextStep::Kind::simulate)
        plan = {first.purpose, first.points};
    ensemble::create_campaign_file(file, input, plan);
}

//! Puts a new campaign file in the place of an old one that nobody works on.
void replace_campaign(fs::path const& file, Checked const& checked)
{
    ensemble::CampaignLock const lock(file, ensemble::CampaignLock::Kind::session);
    fs::path replacement = file;
    replacement += ".replacement";
    fs::remove(replacement);
    create(replacement, checked);
    ensemble::Parts(file).remove();
    fs::rename(replacement, file);
}

int make_new(fs::path const& toml, fs::path const& file, IfExists if_exists,
             std::vector<ensemble::ResultFile> const& results)
{
    auto const checked = read_checked(toml, results);
    if (if_exists == IfExists::replace && fs::exists(file))
        replace_campaign(file, checked);
    else if (fs::exists(file))
        throw InputError(
            fmt::format("{}: exists already; give another name with --output, or --force to lose what "
                        "it holds",
                        file.string()));
    else
        create(file, checked);
    fmt::print("{}wrote {}; run it with: mpirun -n N demens {}\n", checked.plan, file.string(),
               text::shell_word(file.string()));
    return success;
}

//! Changes as lines of their own.
std::string lines_of(std::vector<std::string> const& changes)
{
    return fmt::format("  {}", fmt::join(changes, "\n  "));
}

std::vector<ensemble::ResultFile> result_files(std::vector<std::string> const& words)
{
    std::vector<ensemble::ResultFile> files;
    for (auto const& word : words) {
        auto const equals = fs::exists(word) ? std::string::npos : word.find('=');
        files.push_back(equals == std::string::npos
                            ? ensemble::ResultFile{"", word}
                            : ensemble::ResultFile{word.substr(0, equals), word.substr(equals + 1)});
    }
    return files;
}

} // namespace

fs::path default_campaign_file(fs::path const& toml)
{
    auto file = toml;
    return file.replace_extension(".h5");
}

void make_or_accept(fs::path const& toml, fs::path const& campaign_file)
{
    if (!fs::exists(campaign_file)) {
        auto const checked = read_checked(toml);
        ensemble::require_engine(checked.input.run);
        create(campaign_file, checked);
        fmt::print("{}", checked.plan);
        return;
    }
    auto const input = CampaignInput::from_file(toml);
    auto const stored = ensemble::read_campaign_file(campaign_file).input;
    if (auto const changes = ensemble::input_changes(stored, input); !changes.empty())
        throw InputError(fmt::format(
            "{0}: was made of another input than {1} is now:\n{2}\nTo go on with what is "
            "there: demens {0}; to take over {1} with all runs that still hold: demens extend "
            "{0} --continue {1}; for a new campaign: demens new {1} --output OTHER.h5",
            text::shell_word(campaign_file.string()), text::shell_word(toml.string()), lines_of(changes)));
}

std::string other_input_text(fs::path const& campaign_file, CampaignInput const& stored)
{
    auto toml = campaign_file;
    toml.replace_extension(".toml");
    std::error_code error;
    if (!fs::exists(toml, error))
        return {};
    auto const name = text::shell_word(toml.string()), file = text::shell_word(campaign_file.string());
    try {
        auto const changes = ensemble::input_changes(stored, CampaignInput::from_file(toml));
        return changes.empty() ? ""
                               : fmt::format("note: {0} is not what {1} was made of, and {1} goes on as it "
                                             "was made. What differs, as "
                                             "the campaign has it and as {0} says now:\n{2}\nTo take it "
                                             "over: demens extend {1} --continue {0}",
                                             name, file, lines_of(changes));
    } catch (InputError const&) {
        return fmt::format("note: {} has faults now; {} goes on with what it was made of", name, file);
    }
}

void add_new(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string toml, output;
        std::vector<std::string> results;
        bool force = false;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand("new", "check a TOML file and write its campaign file");
    command->add_option("FILE.toml", options->toml, "the campaign as its author writes it")->required();
    command->add_option("-o,--output", options->output, "campaign file to write; default FILE.h5");
    command->add_option("--results", options->results,
                        "FILE.csv or EXPERIMENT=FILE.csv: runs that were made elsewhere, in the columns that "
                        "`demens export` writes; they are calibrated in the place of a design");
    command->add_flag("--force", options->force, "replace an existing campaign file and lose what it holds");
    command->callback([options, &action] {
        action = [options] {
            return make_new(
                options->toml,
                options->output.empty() ? default_campaign_file(options->toml) : fs::path(options->output),
                options->force ? IfExists::replace : IfExists::refuse, result_files(options->results));
        };
    });
}

} // namespace demens::cli
