#include "ensemble/status.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/progress.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/journal.hpp"
#include "ensemble/storage/lock.hpp"
#include "ensemble/verdict.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

struct RunCounts
{
    int done = 0, failed = 0, running = 0;
    double seconds_open = 0; //!< expected wall time of the runs not done yet
};

RunCounts counts_of_complete(Wave const& wave)
{
    RunCounts counts;
    for (auto const& run : wave.runs) {
        ++counts.done;
        counts.failed += run.status != rig::RunStatus::finished;
    }
    return counts;
}

//! When the session that holds the lock began [s since 1970].
double session_begin(fs::path const& campaign_file)
{
    std::error_code error;
    auto const written = fs::last_write_time(beside(campaign_file, ".lock"), error);
    if (error)
        return 0;
    return std::chrono::duration<double>(std::chrono::file_clock::to_sys(written).time_since_epoch()).count();
}

//! Reads the journals and shards of a wave in progress; any of them may vanish or grow meanwhile.
RunCounts counts_of_open(fs::path const& file, Campaign const& campaign, Wave const& wave, bool is_active)
{
    Parts const parts(file);
    auto const histories = read_journals(parts.folder());
    auto const expected = expected_seconds(campaign, wave);
    double const begin = session_begin(file) - 1;
    RunCounts counts;
    for (std::size_t row = 0; row < wave.runs.size(); ++row) {
        auto const found = histories.find(wave.runs[row].run);
        auto const* history = found == histories.end() ? nullptr : &found->second;
        if (history && !history->shard_crcs.empty()) {
            ++counts.done;
            if (history->status >= 0) {
                counts.failed += history->status != static_cast<int>(rig::RunStatus::finished);
                continue;
            }
            try { // the journal of an earlier program
                counts.failed +=
                    parts.load(wave.runs[row], campaign.input, history->shard_crcs).record.status !=
                    rig::RunStatus::finished;
            } catch (FileError const&) {
                --counts.done; // damaged, or being gathered
            }
            continue;
        }
        counts.running += is_active && history && history->open && history->begun >= begin;
        counts.seconds_open += expected[row];
    }
    return counts;
}

NamedArray const* latest(Campaign const& campaign, stored::ArrayName const& name)
{
    for (auto wave = campaign.waves.rbegin(); wave != campaign.waves.rend(); ++wave)
        if (auto const* array = wave->find(name); array && !array->data.empty())
            return array;
    return nullptr;
}

//! What the targets tell of a factor; empty: nothing yet.
std::string known_of_factor(Campaign const& campaign, std::size_t factor)
{
    std::size_t const factors = campaign.input.factors.size();
    auto const* interval = latest(campaign, stored::optimum::factor_interval);
    auto const* estimate = latest(campaign, stored::optimum::estimate);
    auto const* verdict = latest(campaign, stored::optimum::factor_verdict);
    if (!interval || interval->data.size() != 2 * factors || !estimate || estimate->data.size() != factors ||
        !verdict || verdict->data.size() != factors)
        return {};
    auto const judged = static_cast<Verdict>(verdict->data[factor]);
    if (!has_interval(judged))
        return fmt::format("   {}", name_of(judged));
    return fmt::format("   estimate {:.5g}, 95 % {:.4g} to {:.4g}", estimate->data[factor],
                       interval->data[2 * factor], interval->data[2 * factor + 1]);
}

//! Whether a campaign is calibrated, and waves of its diagnosis are still to run.
bool is_diagnosis_open(Campaign const& campaign)
{
    return campaign.input.gap && !campaign.ended.empty() && !campaign.waves.empty() &&
           (calibrates(campaign.waves.back().purpose) || !is_complete(campaign.waves.back()));
}

} // namespace

std::string best_fit_text(Campaign const& campaign)
{
    auto const* wmse = latest(campaign, stored::optimum::wmse);
    auto const* point = latest(campaign, stored::optimum::best_point);
    if (!wmse || !point || point->data.size() != campaign.input.factors.size())
        return "best fit   none yet\n";
    auto text = fmt::format("best run   weighted mean square error {:.4g}", wmse->data.front());
    if (auto const* run = latest(campaign, stored::optimum::best_run))
        text += fmt::format(" (run {:.0f})", run->data.front());
    text += "\n";
    for (std::size_t k = 0; k < point->data.size(); ++k)
        text += fmt::format("           {:<28} {:>12.5g}{}\n", campaign.input.factors[k].name, point->data[k],
                            known_of_factor(campaign, k));
    auto const* responses = latest(campaign, stored::optimum::best_responses);
    std::size_t t = 0;
    for (auto const& experiment : campaign.input.experiments)
        for (auto const& target : experiment.targets) {
            if (responses && t < responses->data.size())
                text +=
                    fmt::format("           {:<28} {:>12.5g}   target {:.5g}\n",
                                experiment.name + "." + target.response, responses->data[t], target.value);
            ++t;
        }
    return text;
}

std::string status_text(fs::path const& file, Rigs const& rigs)
{
    auto const campaign = read_campaign_file(file, rigs);
    auto const owner = lock_owner(file);
    auto text = fmt::format(
        "campaign   {}\nfile       {}\nstate      {}\n\n", campaign.input.name, file.string(),
        !owner.empty() ? "running, " + owner
        : is_diagnosis_open(campaign)
            ? fmt::format("calibrated ({}); the diagnosis of its gap goes on with: mpirun -n N demens {}",
                          campaign.ended, file.string())
        : !campaign.ended.empty() ? "ended: " + campaign.ended
                                  : "not running; go on with: mpirun -n N demens " + file.string());
    text += fmt::format("{:<6} {:<14} {:>6} {:>6} {:>8} {:>7} {:>13}\n", "wave", "purpose", "runs", "done",
                        "running", "failed", "wall time");
    RunCounts total;
    for (auto const& wave : campaign.waves) {
        bool const complete = is_complete(wave);
        auto const counts =
            complete ? counts_of_complete(wave) : counts_of_open(file, campaign, wave, !owner.empty());
        text += fmt::format("{:<6} {:<14} {:>6} {:>6} {:>8} {:>7} {:>13}\n", wave.number,
                            word_for(wave.purpose), wave.runs.size(), counts.done, counts.running,
                            counts.failed, complete ? duration_text(wave.wall_time) : "");
        total.done += counts.done;
        total.failed += counts.failed;
        total.running += counts.running;
        total.seconds_open += counts.seconds_open;
    }
    text += fmt::format("{:<21} {:>6} {:>6} {:>8} {:>7}\n\n", "all", campaign.runs_planned(), total.done,
                        total.running, total.failed);
    text += best_fit_text(campaign);
    bool const has_rate = std::any_of(campaign.waves.begin(), campaign.waves.end(), is_complete);
    if (total.seconds_open > 0 && has_rate)
        text += fmt::format("time left  {} for the rest of this wave, on {} at a time\n",
                            duration_text(total.seconds_open / std::max(1, total.running)),
                            total.running > 1 ? fmt::format("{} runs", total.running) : "one run");
    return text;
}

} // namespace demens::ensemble
