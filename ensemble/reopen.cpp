#include "ensemble/reopen.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/storage/lock.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

std::uintmax_t constexpr room_for_plan = 1 << 20; //!< [bytes], and some more for each run

//! \throws InputError
void require_runs(Campaign const& campaign, std::set<int> const& runs, std::string const& file)
{
    if (runs.empty())
        throw InputError(fmt::format("{}: no run is named", file));
    int const last = campaign.runs_planned() - 1;
    for (int const run : {*runs.begin(), *runs.rbegin()})
        if (run < 0 || run > last)
            throw InputError(last < 0 ? fmt::format("{}: there is no run {}; none is planned yet", file, run)
                                      : fmt::format("{}: there is no run {}; the campaign has runs 0 to {}",
                                                    file, run, last));
}

//! A diagnosis is made about the estimate of the calibration. \throws InputError
void require_no_diagnosis(Campaign const& campaign, Wave const& wave, std::string const& file)
{
    if (calibrates(wave.purpose) && !calibrates(campaign.waves.back().purpose))
        throw InputError(
            fmt::format("{}: runs of wave {} calibrate, and the diagnosis that follows rests on them; make "
                        "a new campaign of its TOML instead",
                        file, wave.number));
}

bool is_named(Wave const& wave, std::set<int> const& runs)
{
    return std::any_of(wave.runs.begin(), wave.runs.end(),
                       [&](auto const& run) { return runs.contains(run.run); });
}

std::string reason_of_drop(RunRecord const& run, std::string const& reason)
{
    auto text = std::string("dropped by hand");
    if (!reason.empty())
        text += ": " + reason;
    if (run.status != rig::RunStatus::not_run && run.status != rig::RunStatus::dropped)
        text += fmt::format(" (was {}{}{})", rig::name_of(run.status), run.reason.empty() ? "" : ": ",
                            run.reason);
    return text;
}

RunRecord dropped(RunRecord run, std::string const& reason)
{
    run.reason = reason_of_drop(run, reason);
    run.status = rig::RunStatus::dropped;
    return run;
}

//! Results of a wave in the file become shards beside it again, those that are taken back as is their fate.
void write_shards(hid_t file, Campaign const& campaign, Wave const& wave, std::set<int> const& runs,
                  Fate fate, std::string const& reason, Parts const& parts, Journal& journal)
{
    for (std::size_t row = 0; row < wave.runs.size(); ++row) {
        auto record = wave.runs[row];
        bool const is_taken_back = runs.contains(record.run);
        if (is_taken_back && fate == Fate::redo)
            continue;
        auto const& experiment = campaign.input.experiments.at(static_cast<std::size_t>(record.experiment));
        auto details = read_details(file, wave.number, row, experiment.name);
        if (is_taken_back)
            record = dropped(std::move(record), reason);
        parts.store({record, std::move(details)}, campaign.input, journal);
    }
}

//! Runs of a wave in progress, whose results are shards. \param histories of the runs before they are
//! forgotten
void change_shards(Campaign const& campaign, Wave const& wave, std::set<int> const& runs, Fate fate,
                   std::string const& reason, std::map<int, RunHistory> const& histories, Parts const& parts,
                   Journal& journal)
{
    for (auto const& plan : wave.runs) {
        if (!runs.contains(plan.run))
            continue;
        FinishedRun run{plan, {}};
        if (auto const found = histories.find(plan.run); found != histories.end() && fate == Fate::drop)
            try {
                run = parts.load(plan, campaign.input, found->second.shard_crcs);
            } catch (FileError const&) { // nothing is there, or nothing whole
            }
        parts.remove_shard(plan.run);
        if (fate == Fate::drop)
            parts.store({dropped(run.record, reason), run.details}, campaign.input, journal);
    }
}

//! The plan of a wave in the place of its results.
void replace_by_plan(hid_t file, Wave const& wave, CampaignInput const& input, bool keeps_analysis)
{
    hdf5::check(H5Ldelete(file, wave_path(wave.number).c_str(), H5P_DEFAULT), "replace a wave");
    for (char const* kind : {"series", "profiles", "snapshots"})
        if (auto const path = fmt::format("/{}/{:04}", kind, wave.number); hdf5::exists(file, path))
            hdf5::check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), "replace " + path);
    RowWriter writer(file);
    write_plan(writer, wave, input);
    if (keeps_analysis)
        write_analysis(file, wave.number, wave.analysis);
}

void remove_analysis(hid_t file, Wave const& wave)
{
    for (auto const& array : wave.analysis) {
        auto const path = wave_path(wave.number) + "/" + array.path;
        hdf5::check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), "remove " + path);
    }
}

} // namespace

void take_back(fs::path const& file, std::vector<int> const& numbers, Fate fate, std::string const& reason,
               Rigs const& rigs)
{
    std::set<int> const runs(numbers.begin(), numbers.end());
    auto const name = file.string();
    open_campaign(file); // a wrong file is refused before anything is made beside it
    CampaignLock const lock(file, CampaignLock::Kind::session);
    auto const campaign = read_campaign(file, rigs);
    require_runs(campaign, runs, name);
    std::vector<Wave const*> complete, open;
    for (auto const& wave : campaign.waves)
        if (is_named(wave, runs)) {
            require_no_diagnosis(campaign, wave, name);
            (is_complete(wave) ? complete : open).push_back(&wave);
        }

    Parts const parts(file);
    if (std::all_of(campaign.waves.begin(), campaign.waves.end(), is_complete))
        parts.remove(); // left over from a kill
    parts.make_folder();
    auto const histories = read_journals(parts.folder());
    forget_runs(parts.folder(), runs);
    Journal journal(parts.folder(), "taken-back");
    for (auto const* wave : open)
        change_shards(campaign, *wave, runs, fate, reason, histories, parts, journal);
    if (complete.empty())
        return;
    std::uintmax_t bytes = room_for_plan;
    {
        auto const source = open_campaign(file);
        for (auto const* wave : complete) {
            write_shards(source, campaign, *wave, runs, fate, reason, parts, journal);
            bytes += 256 * wave->runs.size();
            for (auto const& array : wave->analysis)
                bytes += 4096 + 8 * array.data.size();
        }
    }
    auto const& last = campaign.waves.back();
    bool const goes_on_calibrating = calibrates(last.purpose);
    update_file(file, bytes, [&](hid_t target) {
        for (auto const* wave : complete)
            replace_by_plan(target, *wave, campaign.input, wave != &last);
        if (complete.back() != &last)
            remove_analysis(target, last);
        if (goes_on_calibrating)
            hdf5::set_attribute(target, "/", "ended", "");
    });
}

} // namespace demens::ensemble
