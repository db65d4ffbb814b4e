#include "ensemble/reuse/extension.hpp"

#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/reuse/input_changes.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

bool has_ended(RunRecord const& run)
{
    return run.status != rig::RunStatus::not_run && run.status != rig::RunStatus::dropped;
}

//! Runs that are planned count as if they had ended: would they hold, too?
Campaign as_if_ended(Campaign campaign)
{
    for (auto& wave : campaign.waves)
        for (auto& run : wave.runs)
            if (!has_ended(run)) {
                auto const& experiment = campaign.input.experiments[static_cast<std::size_t>(run.experiment)];
                run.status = rig::RunStatus::finished;
                run.responses.assign(experiment.responses.size(), 0);
            }
    return campaign;
}

bool have_same_names(CampaignInput const& one, CampaignInput const& other)
{
    auto const are_same = [](Experiment const& a, Experiment const& b) {
        return a.name == b.name && a.replicates == b.replicates && a.role == b.role &&
               std::equal(a.responses.begin(), a.responses.end(), b.responses.begin(), b.responses.end(),
                          [](auto const& r, auto const& s) { return r.name == s.name; });
    };
    return one.seed == other.seed &&
           std::equal(one.factors.begin(), one.factors.end(), other.factors.begin(), other.factors.end(),
                      [](auto const& a, auto const& b) { return a.path == b.path; }) &&
           std::equal(one.experiments.begin(), one.experiments.end(), other.experiments.begin(),
                      other.experiments.end(), are_same);
}

//! Whether all runs, planned ones too, are what they were under the other input.
bool holds_as_it_is(CampaignInput const& input, Campaign const& there)
{
    if (!have_same_names(input, there.input) ||
        !std::all_of(there.waves.begin(), there.waves.end(),
                     [](auto const& wave) { return calibrates(wave.purpose); }))
        return false;
    auto const all = as_if_ended(there);
    auto const rows = rows_that_hold(input, all);
    auto const before = all.all_runs();
    return std::equal(rows.runs.begin(), rows.runs.end(), before.begin(), before.end(),
                      [](auto const& now, auto const& was) {
                          return now.run == was.run && now.experiment == was.experiment &&
                                 now.factors == was.factors;
                      });
}

//! A file with the input alone.
void write_begin(fs::path const& file, CampaignInput const& input)
{
    auto begin = hdf5::create_in_memory();
    write_header(begin, input);
    write_durably(file, begin.take_image());
}

void remove_analyses(hid_t file, Campaign const& campaign)
{
    for (auto const& wave : campaign.waves)
        for (auto const& array : wave.analysis) {
            auto const path = wave_path(wave.number) + "/" + array.path;
            hdf5::check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), "remove " + path);
        }
}

void write_kept(RowWriter& writer, CampaignWithShards const& there, ExtensionPlan const& plan)
{
    auto const before = there.campaign().all_runs();
    for (auto const& [wave, runs_there] : plan.kept) {
        std::vector<RunDetails> details;
        for (int const run : runs_there)
            details.push_back(there.details(before.at(static_cast<std::size_t>(run))));
        write_plan(writer, wave, plan.input);
        write_results(writer, wave, plan.input);
        write_details(writer, wave.number, wave.runs, details, plan.input);
    }
}

//! Earlier extensions with the numbers that waves have now.
std::vector<Extension> renumbered(Campaign const& there, std::vector<KeptWave> const& kept)
{
    auto const before = there.all_runs();
    auto extensions = there.extensions;
    for (auto& extension : extensions)
        extension.first_wave =
            static_cast<int>(std::count_if(kept.begin(), kept.end(), [&](KeptWave const& wave) {
                return before.at(static_cast<std::size_t>(wave.runs_there.front())).wave <
                       extension.first_wave;
            }));
    return extensions;
}

//! What is in the file of that name stays there under another one. \return that; empty where nothing is
fs::path keep_file(fs::path const& file)
{
    if (!fs::exists(file))
        return {};
    auto const kept = name_of_kept_file(file);
    if (fs::exists(kept))
        return kept;
    std::error_code error;
    fs::create_hard_link(file, kept, error);
    if (error)
        copy_to_new(file, kept);
    return kept;
}

} // namespace

CampaignWithShards::CampaignWithShards(fs::path file, Rigs const& rigs)
    : file_(std::move(file)), campaign_(read_campaign_file(file_, rigs)),
      is_in_progress_(campaign_.open_wave() != nullptr), opened_(hdf5::open_to_read(file_))
{
    Parts const parts(file_);
    auto const histories = read_journals(parts.folder());
    for (auto& wave : campaign_.waves)
        for (auto& run : wave.runs) {
            auto const history = histories.find(run.run);
            if (run.status != rig::RunStatus::not_run || history == histories.end() ||
                history->second.shard_crcs.empty())
                continue;
            try {
                auto finished = parts.load(run, campaign_.input, history->second.shard_crcs);
                run = std::move(finished.record);
                beside_.emplace(run.run, std::move(finished.details));
            } catch (FileError const&) { // as if it had never ended
            }
        }
}

RunDetails CampaignWithShards::details(RunRecord const& run) const
{
    if (auto const found = beside_.find(run.run); found != beside_.end())
        return found->second;
    auto const& runs = campaign_.waves.at(static_cast<std::size_t>(run.wave)).runs;
    auto const& experiment = campaign_.input.experiments.at(static_cast<std::size_t>(run.experiment));
    return read_details(opened_, run.wave, static_cast<std::size_t>(run.run - runs.front().run),
                        experiment.name);
}

Campaign ExtensionPlan::campaign_of(Campaign const& there) const
{
    Campaign campaign{input, {}, {}, there.extensions};
    campaign.extensions.push_back(extension);
    if (keeping == Keeping::whole_file)
        campaign.waves = there.waves;
    else
        for (auto const& wave : kept)
            campaign.waves.push_back(wave.wave);
    return campaign;
}

ExtensionPlan plan_extension(CampaignInput const& input, int runs, CampaignWithShards const& there,
                             std::string const& source, Keeping widest)
{
    auto const& before = there.campaign();
    ExtensionPlan plan{input, {0, runs, input_changes(before.input, input), before.input.text()}};
    if (runs > 0) {
        plan.input.stop.runs = runs;
        plan.extension.changes.push_back(fmt::format("{} more runs, whatever the goals of [stop]", runs));
    }
    for (auto const& run : before.all_runs())
        plan.ended += has_ended(run);
    if (widest == Keeping::whole_file && holds_as_it_is(input, before)) {
        plan.held = plan.ended;
        plan.extension.first_wave = static_cast<int>(before.waves.size());
        return plan;
    }
    plan.keeping = Keeping::runs;
    auto rows = rows_that_hold(input, before, [&](RunRecord const& run) { return there.details(run); });
    plan.differences = std::move(rows.differences);
    plan.held = static_cast<int>(rows.runs.size());
    plan.kept = kept_waves(input, rows.runs, before, source);
    plan.extension.first_wave = static_cast<int>(plan.kept.size());
    return plan;
}

fs::path name_of_kept_file(fs::path const& file)
{
    for (int number = 1;; ++number) {
        auto kept = file;
        kept.replace_filename(
            fmt::format("{}.before-{}{}", file.stem().string(), number, file.extension().string()));
        if (!fs::exists(kept) || fs::equivalent(kept, file)) // the latter: of an extension that was cut off
            return kept;
    }
}

fs::path write_extension(fs::path const& file, CampaignWithShards const& there, ExtensionPlan const& plan,
                         std::vector<Wave> const& waves)
{
    constexpr std::uintmax_t room = 4 << 20; // [bytes] of tables without particles
    bool const anew = plan.keeping == Keeping::runs;
    auto const begin = beside(file, ".begin");
    if (anew)
        write_begin(begin, plan.input);
    FileUpdate update(file, anew ? begin : there.file(), room);
    fs::remove(begin);
    auto opened = hdf5::open_to_write(update.copy());
    RowWriter writer(opened);
    if (anew) {
        write_kept(writer, there, plan);
        for (auto const& earlier : renumbered(there.campaign(), plan.kept))
            write_extension(opened, earlier);
    } else {
        replace_input(opened, plan.input);
        if (!keeps_analyses(plan.extension.changes))
            remove_analyses(opened, there.campaign());
        hdf5::set_attribute(opened, "/", "ended", "");
    }
    write_extension(opened, plan.extension);
    for (auto const& wave : waves)
        write_plan(writer, wave, plan.input);
    opened.close();
    update.verify();
    auto const kept = anew ? keep_file(file) : fs::path();
    update.commit();
    if (anew && fs::exists(beside(file, ".parts")))
        fs::rename(beside(file, ".parts"), beside(kept, ".parts"));
    return kept;
}

} // namespace demens::ensemble
