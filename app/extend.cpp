// A campaign goes on: with more runs, or with another input and the runs that still hold.
#include "app/checks.hpp"
#include "app/command.hpp"
#include "app/new_campaign.hpp"
#include "demens/base/error.hpp"
#include "demens/base/text/shell.hpp"
#include "demens/base/words.hpp"
#include "ensemble/input/design_table.hpp"
#include "ensemble/reuse/extension.hpp"
#include "ensemble/reuse/input_changes.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/session.hpp"
#include "ensemble/status/campaign_status.hpp"
#include "ensemble/storage/lock.hpp"
#include "tao_calib/wave/completing_waves.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;
using ensemble::Campaign, ensemble::CampaignInput, ensemble::ExtensionPlan;

struct ExtendOptions
{
    std::string file, toml, output;
    int runs = 0;
};

//! Best point and estimate of another campaign, as far as it has factors of the same paths or names.
std::vector<std::vector<double>> starts_from(Campaign const& there, CampaignInput const& input)
{
    auto const best = ensemble::best_fit(there);
    if (!best)
        return {};
    std::vector<double> found, estimated;
    bool is_known = true;
    for (auto const& factor : input.factors) {
        auto const& others = there.input.factors;
        auto other = std::find_if(others.begin(), others.end(),
                                  [&](auto const& one) { return one.path == factor.path; });
        if (other == others.end())
            other = std::find_if(others.begin(), others.end(),
                                 [&](auto const& one) { return one.name == factor.name; });
        if (other == others.end() || !factor.levels.empty())
            return {};
        auto const& fit = best->factors.at(static_cast<std::size_t>(other - others.begin()));
        found.push_back(std::clamp(fit.value, factor.lower, factor.upper));
        is_known = is_known && fit.known && std::isfinite(fit.known->estimate);
        if (is_known)
            estimated.push_back(std::clamp(fit.known->estimate, factor.lower, factor.upper));
    }
    if (is_known && estimated != found)
        return {found, estimated};
    return {found};
}

std::vector<std::vector<double>> within_constraints(std::vector<std::vector<double>> points,
                                                    CampaignInput const& input)
{
    std::erase_if(
        points, [&](auto const& point) { return !ensemble::input::broken_constraint(input, point).empty(); });
    return points;
}

std::string reasons(ExtensionPlan const& plan)
{
    return plan.differences.empty() ? "; none has ended"
                                    : fmt::format(":\n  {}", fmt::join(plan.differences, "\n  "));
}

//! What is to be run first, with its points in the file. \throws InputError where [stop] does not allow it
std::vector<ensemble::Wave> first_waves(ExtensionPlan const& plan, Campaign const& there,
                                        std::vector<std::vector<double>> const& starts)
{
    auto campaign = plan.campaign_of(there);
    auto const waves_before = campaign.waves.size();
    std::vector<ensemble::Wave> waves;
    for (auto const& wave : tao_calib::completing_waves(campaign, starts)) {
        waves.push_back(ensemble::plan_runs(campaign, wave));
        campaign.waves.push_back(waves.back());
    }
    std::size_t runs = 0;
    for (auto wave = waves_before; wave < campaign.waves.size(); ++wave)
        runs += campaign.waves[wave].runs.size();
    if (runs > static_cast<std::size_t>(plan.input.stop.runs))
        throw InputError(
            fmt::format("{} runs are needed first, where no run that is kept has been, and [stop] "
                        "runs = {} allows fewer; raise it, or give --runs {}",
                        runs, plan.input.stop.runs, runs));
    return waves;
}

void print(fs::path const& file, ExtensionPlan const& plan, std::vector<ensemble::Wave> const& waves)
{
    fmt::print("{}: {} of the {} runs that have ended are kept\n", file.string(), plan.held, plan.ended);
    for (auto const& change : plan.extension.changes)
        fmt::print("  changed: {}\n", change);
    for (auto const& difference : plan.differences)
        fmt::print("  not kept: {}\n", difference);
    for (auto const& warning : plan.input.warnings())
        fmt::print("  warning: {}\n", warning);
    for (auto const& wave : waves)
        fmt::print("  first come {} runs (wave {}, {})\n", wave.runs.size(), wave.number,
                   word_for(wave.purpose));
    fmt::print("  then as [stop] says, counted from here: at most {} runs{}\n", plan.input.stop.runs,
               plan.extension.runs > 0 ? ", whether or not its goals are met" : "");
}

//! \throws InputError
void check(ExtendOptions const& options)
{
    if (options.toml.empty() && options.runs == 0)
        throw InputError("say how the campaign goes on: --runs N for more runs, --continue NEW.toml for "
                         "another input");
    if (!options.output.empty() && fs::exists(options.output))
        throw InputError(fmt::format("--output {}: exists already; give another name", options.output));
    if (!fs::exists(options.file))
        throw InputError(
            fmt::format("{}: no such file; a campaign file is made by: demens new FILE.toml", options.file));
}

int extend(ExtendOptions const& options)
{
    check(options);
    fs::path const file = options.file, target = options.output.empty() ? file : fs::path(options.output);
    bool const in_place = options.output.empty();
    ensemble::read_campaign_file(file); // a wrong file is refused before anything is made beside it
    ensemble::CampaignLock const lock(target, ensemble::CampaignLock::Kind::session);
    ensemble::CampaignWithShards const there(file);
    auto const& before = there.campaign();
    auto const input = options.toml.empty() ? before.input : CampaignInput::from_file(options.toml);
    if (!options.toml.empty() && options.runs == 0 && ensemble::is_same_input(before.input, input))
        throw InputError(fmt::format("--continue {}: says what {} was made of; for more runs give --runs N",
                                     options.toml, options.file));
    auto const plan = ensemble::plan_extension(
        input, options.runs, there,
        ensemble::source_text(file, in_place ? ensemble::name_of_kept_file(file) : file),
        in_place || !there.is_in_progress() ? ensemble::Keeping::whole_file : ensemble::Keeping::runs);
    if (plan.ended == 0 && in_place)
        throw InputError(
            fmt::format("{}: no run of it has ended, so that there is nothing to go on from; run it first "
                        "(demens {}), or make it anew: demens new FILE.toml --force",
                        options.file, text::shell_word(options.file)));
    if (plan.held == 0 && in_place)
        throw InputError(fmt::format("{}: none of its {} runs holds for {}{}\nA new campaign that begins "
                                     "with its best point: --output OTHER.h5",
                                     options.file, before.runs_planned(),
                                     options.toml.empty() ? options.file : options.toml, reasons(plan)));
    auto const starts = plan.held == 0 ? within_constraints(starts_from(before, input), input)
                                       : std::vector<std::vector<double>>{};
    if (plan.held == 0 && starts.empty())
        throw InputError(fmt::format("{}: none of its runs holds for {}, and it has no best point with all "
                                     "factors of it{}",
                                     options.file, options.toml, reasons(plan)));
    auto const waves = first_waves(plan, before, starts);
    auto const kept = ensemble::write_extension(target, there, plan, waves);
    print(target, plan, waves);
    if (!kept.empty())
        fmt::print("  as it was, with all its runs: {}\n", kept.string());
    fmt::print("go on with: mpirun -n N demens {}\n", text::shell_word(target.string()));
    return success;
}

} // namespace

void add_extend(CLI::App& program, Action& action)
{
    auto options = std::make_shared<ExtendOptions>();
    auto* command = program.add_subcommand(
        "extend", "go on with a campaign: more runs, or another input with the runs that still hold");
    command->add_option("FILE.h5", options->file, "campaign file; nobody may work on it")->required();
    command->add_option("--runs", options->runs, "so many more runs, whatever the goals of [stop]")
        ->check(above_zero());
    command->add_option("--continue", options->toml,
                        "TOML file that says from now on what is measured, varied and searched");
    command->add_option("-o,--output", options->output,
                        "campaign file to write; FILE.h5 then stays as it is; default FILE.h5");
    command->callback([options, &action] { action = [options] { return extend(*options); }; });
}

} // namespace demens::cli
