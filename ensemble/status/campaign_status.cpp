#include "ensemble/status/campaign_status.hpp"

#include "demens/base/words.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/run/schedule.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/journal.hpp"
#include "ensemble/storage/lock.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace demens {

template <>
std::vector<Word<ensemble::CampaignState>> const& words_of()
{
    using enum ensemble::CampaignState;
    static std::vector<Word<ensemble::CampaignState>> const words = {
        {running, "running"}, {waiting, "waiting"}, {to_diagnose, "to diagnose"}, {ended, "ended"}};
    return words;
}

} // namespace demens

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

int constexpr reasons_read = 20; //!< of failed runs of a wave in progress, which lie in a file each

//! When the session that holds the lock began [s since 1970].
double session_begin(fs::path const& campaign_file)
{
    std::error_code error;
    auto const written = fs::last_write_time(beside(campaign_file, ".lock"), error);
    if (error)
        return 0;
    return std::chrono::duration<double>(std::chrono::file_clock::to_sys(written).time_since_epoch()).count();
}

//! Whether a campaign is calibrated, and waves of its diagnosis are still to run.
bool is_diagnosis_open(Campaign const& campaign)
{
    return campaign.input.gap && !campaign.ended.empty() && !campaign.waves.empty() &&
           (calibrates(campaign.waves.back().purpose) || !is_complete(campaign.waves.back()));
}

CampaignState state_of(Campaign const& campaign, std::string const& owner)
{
    if (!owner.empty())
        return CampaignState::running;
    if (is_diagnosis_open(campaign))
        return CampaignState::to_diagnose;
    return campaign.ended.empty() ? CampaignState::waiting : CampaignState::ended;
}

//! Collects what is known of the runs of a campaign, wave by wave.
class Reader
{
  public:
    Reader(fs::path const& file, Campaign const& campaign, CampaignStatus& status)
        : file_(file), campaign_(campaign), status_(status)
    {
    }

    void take_complete(Wave const& wave)
    {
        WaveStatus shown = begin(wave);
        for (auto const& run : wave.runs) {
            ++shown.runs.done;
            note_end(shown, run.run, run.status, run.reason);
        }
        shown.is_complete = true;
        shown.wall_time = wave.wall_time;
        if (wave.taken_from.empty() && time_of_groups(wave) > 0) {
            shown.busy_share = time_in_runs(wave) / time_of_groups(wave);
            time_in_runs_ += time_in_runs(wave);
            time_of_groups_ += time_of_groups(wave);
            status_.busy_share = time_in_runs_ / time_of_groups_;
        }
        end(shown);
    }

    //! Reads the journals and shards of a wave in progress; any of them may vanish or grow meanwhile.
    void take_open(Wave const& wave)
    {
        WaveStatus shown = begin(wave);
        Parts const parts(file_);
        auto const histories = read_journals(parts.folder());
        auto const expected = expected_times(campaign_, wave, finished_times(histories));
        double const begun_after = session_begin(file_) - 1, time = seconds_since_epoch();
        for (std::size_t row = 0; row < wave.runs.size(); ++row) {
            auto const& plan = wave.runs[row];
            auto const found = histories.find(plan.run);
            auto const* history = found == histories.end() ? nullptr : &found->second;
            bool const runs =
                history && history->open && !status_.owner.empty() && history->begun >= begun_after;
            if (history) {
                shown.begun_again.lost +=
                    std::max(0, history->deaths + history->deaths_alone - (runs ? 1 : 0));
                shown.begun_again.crashed += history->crashes;
                shown.begun_again.stopped += history->stops;
            }
            if (history && !history->shard_crcs.empty() && take_shard(shown, parts, plan, *history))
                continue;
            double left = expected.seconds[row];
            if (runs) {
                ++shown.runs.running;
                double const elapsed = time - history->begun;
                auto const whole = whole_time(expected, row, *history);
                status_.in_progress.push_back(
                    {plan.run, campaign_.input.experiments[static_cast<std::size_t>(plan.experiment)].name,
                     elapsed, whole, history->share, history->moment});
                left = whole.value_or(left);
                left = std::max(0.05 * left, left - elapsed);
            }
            seconds_open_ += left;
            squares_open_ += left * left;
            longest_open_ = std::max(longest_open_, left);
        }
        std::sort(status_.in_progress.begin(), status_.in_progress.end(),
                  [](auto const& a, auto const& b) { return a.elapsed > b.elapsed; });
        estimate_time_left(expected, shown.runs.running);
        end(shown);
    }

  private:
    //! How long a run in progress takes as a whole [s].
    static std::optional<double> whole_time(ExpectedTimes const& expected, std::size_t row,
                                            RunHistory const& history)
    {
        constexpr double enough = 0.05; // to go by
        if (history.share >= enough && history.share <= 1 && history.told > history.begun)
            return (history.told - history.begun) / history.share;
        return expected.finished > 0 ? std::optional(expected.seconds[row]) : std::nullopt;
    }

    static WaveStatus begin(Wave const& wave)
    {
        WaveStatus shown;
        shown.number = wave.number;
        shown.purpose = wave.purpose;
        shown.runs.planned = static_cast<int>(wave.runs.size());
        shown.busy_share = std::numeric_limits<double>::quiet_NaN();
        return shown;
    }

    void end(WaveStatus const& shown)
    {
        status_.waves.push_back(shown);
        status_.all.planned += shown.runs.planned;
        status_.all.done += shown.runs.done;
        status_.all.failed += shown.runs.failed;
        status_.all.running += shown.runs.running;
        status_.all.dropped += shown.runs.dropped;
    }

    void note_end(WaveStatus& shown, int run, rig::RunStatus how, std::string const& reason)
    {
        shown.runs.dropped += how == rig::RunStatus::dropped;
        if (!rig::has_failed(how))
            return;
        ++shown.runs.failed;
        auto& all = status_.failures;
        auto found = std::find_if(all.begin(), all.end(), [&](auto const& one) { return one.status == how; });
        if (found == all.end())
            found = all.insert(all.end(), {.status = how, .runs = 0, .first_run = run, .reason = reason});
        if (found->reason.empty() && !reason.empty()) {
            found->first_run = run;
            found->reason = reason;
        }
        ++found->runs;
    }

    static std::map<int, double> finished_times(std::map<int, RunHistory> const& histories)
    {
        std::map<int, double> times;
        for (auto const& [run, history] : histories)
            if (history.status == static_cast<int>(rig::RunStatus::finished) && history.seconds >= 0)
                times[run] = history.seconds;
        return times;
    }

    //! \return whether the run is done
    bool take_shard(WaveStatus& shown, Parts const& parts, RunRecord const& plan, RunHistory const& history)
    {
        if (history.status == static_cast<int>(rig::RunStatus::finished)) {
            ++shown.runs.done;
            return true;
        }
        bool const is_told = history.status >= 0;
        if (is_told && ++reasons_ > reasons_read) {
            ++shown.runs.done;
            note_end(shown, plan.run, static_cast<rig::RunStatus>(history.status), "");
            return true;
        }
        try {
            auto const record = parts.load(plan, campaign_.input, history.shard_crcs).record;
            ++shown.runs.done;
            note_end(shown, plan.run, record.status, record.reason);
            return true;
        } catch (FileError const&) { // damaged, or being gathered
            if (!is_told)
                return false;
            ++shown.runs.done;
            note_end(shown, plan.run, static_cast<rig::RunStatus>(history.status), "");
            return true;
        }
    }

    void estimate_time_left(ExpectedTimes const& expected, int running)
    {
        if (expected.finished == 0 || seconds_open_ <= 0)
            return;
        int const at_a_time = std::max(1, running);
        TimeLeft left;
        left.at_a_time = at_a_time;
        left.seconds = std::max(longest_open_, seconds_open_ / at_a_time);
        // each run's own deviation, and that of the rate, which all have in common
        left.standard_error = expected.scatter * std::sqrt(squares_open_ / (at_a_time * at_a_time) +
                                                           left.seconds * left.seconds / expected.finished);
        status_.time_left = left;
    }

    fs::path file_;
    Campaign const& campaign_;
    CampaignStatus& status_;
    int reasons_ = 0;
    double time_in_runs_ = 0, time_of_groups_ = 0; //!< [s] of complete waves
    double seconds_open_ = 0, squares_open_ = 0, longest_open_ = 0;
};

NamedArray const* latest(Campaign const& campaign, stored::ArrayName const& name)
{
    for (auto wave = campaign.waves.rbegin(); wave != campaign.waves.rend(); ++wave)
        if (auto const* array = wave->find(name); array && !array->data.empty())
            return array;
    return nullptr;
}

//! What the targets tell of a factor; none: nothing yet.
std::optional<BestFit::Known> known_of_factor(Campaign const& campaign, std::size_t factor)
{
    std::size_t const factors = campaign.input.factors.size();
    auto const* interval = latest(campaign, stored::optimum::factor_interval);
    auto const* estimate = latest(campaign, stored::optimum::estimate);
    auto const* verdict = latest(campaign, stored::optimum::factor_verdict);
    if (!interval || interval->data.size() != 2 * factors || !estimate || estimate->data.size() != factors ||
        !verdict || verdict->data.size() != factors)
        return {};
    return BestFit::Known{estimate->data[factor], interval->data[2 * factor], interval->data[2 * factor + 1],
                          static_cast<Verdict>(verdict->data[factor])};
}

} // namespace

std::optional<BestFit> best_fit(Campaign const& campaign)
{
    auto const* wmse = latest(campaign, stored::optimum::wmse);
    auto const* point = latest(campaign, stored::optimum::best_point);
    if (!wmse || !point || point->data.size() != campaign.input.factors.size())
        return {};
    BestFit best;
    best.wmse = wmse->data.front();
    if (auto const* run = latest(campaign, stored::optimum::best_run))
        best.run = static_cast<int>(run->data.front());
    for (std::size_t k = 0; k < point->data.size(); ++k)
        best.factors.push_back(
            {campaign.input.factors[k].name, point->data[k], known_of_factor(campaign, k)});
    auto const* responses = latest(campaign, stored::optimum::best_responses);
    std::size_t t = 0;
    for (auto const& experiment : campaign.input.experiments)
        for (auto const& target : experiment.targets) {
            if (responses && t < responses->data.size())
                best.responses.push_back({experiment.name + "." + target.response, responses->data[t],
                                          target.value, target.scale});
            ++t;
        }
    if (responses && responses->data.size() == t)
        best.quality = fit_quality(campaign.input, responses->data);
    for (auto wave = campaign.waves.rbegin(); wave != campaign.waves.rend() && best.targets.empty(); ++wave) {
        best.targets = targets_text(*wave);
        best.noise_inflation = noise_inflation(*wave);
    }
    return best;
}

CampaignStatus read_status(fs::path const& file, Rigs const& rigs)
{
    auto const campaign = read_campaign_file(file, rigs);
    CampaignStatus status;
    status.name = campaign.input.name;
    status.file = file.string();
    status.owner = lock_owner(file);
    status.ended = campaign.ended;
    status.extensions = campaign.extensions;
    status.state = state_of(campaign, status.owner);
    Reader reader(file, campaign, status);
    for (auto const& wave : campaign.waves) {
        if (is_complete(wave))
            reader.take_complete(wave);
        else
            reader.take_open(wave);
    }
    std::stable_sort(status.failures.begin(), status.failures.end(),
                     [](auto const& a, auto const& b) { return a.runs > b.runs; });
    status.best = best_fit(campaign);
    return status;
}

} // namespace demens::ensemble
