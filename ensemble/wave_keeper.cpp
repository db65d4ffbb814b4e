#include "ensemble/wave_keeper.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/gather.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/schedule.hpp"
#include "ensemble/shared_campaign.hpp"
#include "ensemble/wave_inspection.hpp"

#include <algorithm>

namespace demens::ensemble {
namespace {

//! [s] When the last run of a complete wave ended, since the wave began or, if it was planned ahead, the
//! first of those that overlap.
double end_of(Wave const& wave)
{
    double end = 0;
    for (auto const& run : wave.runs)
        end = std::max(end, run.start_time + run.wall_time);
    return end;
}

} // namespace

void WaveKeeper::plan(MPI_Comm communicator, WavePlan const& plan)
{
    auto const number = static_cast<int>(campaign_.waves.size());
    on_root(communicator, [&] {
        auto wave = plan_runs(campaign_, plan);
        if (wave.runs.empty())
            throw InputError("a wave needs at least one design point");
        wave.planned_ahead = campaign_.open_wave() != nullptr;
        update_file(file_, small_change + 256 * wave.runs.size(), [&](hid_t file) {
            RowWriter writer(file);
            write_plan(writer, wave, campaign_.input);
        });
        campaign_.waves.push_back(std::move(wave));
    });
    share_wave(communicator, campaign_, number);
}

WaveState WaveKeeper::inspect_and_quarantine(MPI_Comm communicator, Wave const& wave, Journal* journal) const
{
    while (true) {
        std::map<int, RunHistory> histories;
        auto state = inspect(communicator, parts_, wave, campaign_.input, histories);
        on_root(communicator, [&] {
            for (int const row : state.poisonous) {
                FinishedRun quarantined{wave.runs[static_cast<std::size_t>(row)], {}};
                quarantined.record.status = rig::RunStatus::quarantined;
                quarantined.record.reason = quarantine_reason(histories[quarantined.record.run]);
                parts_.store(quarantined, campaign_.input, *journal);
            }
        });
        std::vector<int> poisonous(1, static_cast<int>(state.poisonous.size()));
        broadcast(communicator, poisonous);
        if (poisonous.front() == 0)
            return state;
    }
}

SeenWave WaveKeeper::look_at(MPI_Comm communicator, Wave const& wave, Journal* journal) const
{
    SeenWave seen;
    auto& work = seen.work;
    std::vector<int> counts(2);
    std::vector<double> clock(1);
    auto const state = inspect_and_quarantine(communicator, wave, journal);
    on_root(communicator, [&] {
        std::map<int, double> measured;
        if (wave.planned_ahead && is_complete(campaign_.waves.at(static_cast<std::size_t>(wave.number) - 1)))
            clock[0] = end_of(campaign_.waves[static_cast<std::size_t>(wave.number) - 1]);
        for (std::size_t row = 0; row < state.shards.size(); ++row) {
            auto const& shard = state.shards[row];
            seen.crcs.push_back(shard.crc);
            if (shard.crc == 0)
                continue;
            if (shard.status == rig::RunStatus::finished)
                measured[wave.runs[row].run] = shard.wall_time;
            clock[0] = std::max(clock[0], shard.start_time + shard.wall_time);
            ++counts[0];
            counts[1] += rig::has_failed(shard.status);
        }
        auto const expected = expected_times(campaign_, wave, measured);
        work.seconds = expected.seconds;
        work.limits = wall_time_limits(campaign_.input.run, expected);
        work.pending = longest_first(state.pending, work.seconds);
        work.suspicious = longest_first(state.suspicious, work.seconds);
    });
    broadcast(communicator, work.pending);
    broadcast(communicator, work.suspicious);
    broadcast(communicator, work.seconds);
    broadcast(communicator, work.limits);
    broadcast(communicator, counts);
    broadcast(communicator, clock);
    work.clock = clock[0];
    work.done = counts[0];
    work.failed = counts[1];
    return seen;
}

//! Of waves that overlap, each counts from the end of the one before, so that their sum is the time that
//! passed.
double WaveKeeper::wall_time_until(int number, double clock) const
{
    auto const place = static_cast<std::size_t>(number);
    if (!campaign_.waves[place].planned_ahead)
        return clock;
    return std::max(0.0, clock - end_of(campaign_.waves[place - 1]));
}

void WaveKeeper::groups_begin(int number)
{
    if (idle_since_)
        time_before_[number] += std::chrono::duration<double>(Clock::now() - *idle_since_).count();
    idle_since_.reset();
}

void WaveKeeper::gather(MPI_Comm communicator, int number, SeenWave const& seen, int groups)
{
    auto const place = static_cast<std::size_t>(number);
    FinishedWave finished{campaign_.waves.at(place), seen.crcs};
    // Every rank takes the rows that are its own by the check sums of rank 0.
    std::vector<int> crcs(seen.crcs.begin(), seen.crcs.end());
    broadcast(communicator, crcs);
    finished.crcs.assign(crcs.begin(), crcs.end());
    finished.wave.groups = groups;
    finished.wave.time_before = time_before_[number];
    finished.wave.wall_time = wall_time_until(number, seen.work.clock);
    ensemble::gather(communicator, file_, campaign_.input, parts_, finished);
    on_root(communicator, [&] {
        auto& wave = campaign_.waves[place];
        wave = read_wave(open_campaign(file_), number, campaign_.input);
        if (campaign_.open_wave())
            parts_.remove_shards(wave);
        else
            parts_.remove();
    });
    share_wave(communicator, campaign_, number);
}

void WaveKeeper::store_analysis(MPI_Comm communicator, int number, std::vector<NamedArray> const& analysis)
{
    on_root(communicator, [&] {
        auto bytes = small_change;
        for (auto const& array : analysis)
            bytes += 4096 + 8 * array.data.size();
        update_file(file_, bytes, [&](hid_t file) { write_analysis(file, number, analysis); });
        campaign_.waves.at(static_cast<std::size_t>(number)) =
            read_wave(open_campaign(file_), number, campaign_.input);
    });
    share_wave(communicator, campaign_, number);
}

} // namespace demens::ensemble
