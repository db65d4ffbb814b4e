#include "ensemble/session.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/gather.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/schedule.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/run/wave_runner.hpp"
#include "ensemble/shared_campaign.hpp"
#include "ensemble/storage/lock.hpp"
#include "ensemble/wave_inspection.hpp"

#include <algorithm>
#include <cassert>
#include <exception>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

std::uintmax_t constexpr small_change = 1 << 20; //!< [bytes] of tables without particles

//! Whether any rank is asked to stop. Collective.
bool is_stop_requested(MPI_Comm communicator)
{
    int requested = StopSignals::request() != StopRequest::none;
    MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator);
    return requested != 0;
}

} // namespace

struct Session::Implementation
{
    Implementation(MPI_Comm parent, fs::path path, SessionOptions session_options)
        : communicator(Communicator::duplicate(parent)), file(std::move(path)), parts(file),
          options(std::move(session_options))
    {
        on_root(communicator, [&] {
            open_campaign(file); // a wrong file is refused before anything is made beside it
            lock = std::make_unique<CampaignLock>(file, CampaignLock::Kind::session);
            fs::remove(beside(file, ".new"));
        });
        on_all(communicator, [&] { presence = std::make_unique<PresenceMark>(file); });
        campaign = std::make_unique<Campaign>(read_for_all(communicator, file, options.rigs));
        on_all(communicator, [&] { require_engine(campaign->input.run); });
        groups = std::make_unique<Groups>(communicator, campaign->input.run.ranks_per_group);
        if (is_root() && !campaign->open_wave())
            parts.remove(); // left over from a kill between a gather and its tidying up
    }

    ~Implementation()
    {
        presence.reset();
        if (std::uncaught_exceptions() ==
            exceptions_before)         // a rank that fails alone must not wait for the others
            MPI_Barrier(communicator); // the next session finds nobody at work
    }

    bool is_root() const { return rank_of(communicator) == 0; }

    //! The state of the wave; runs that are not begun again get their status here.
    WaveState inspect_and_quarantine(Wave const& wave, Journal* journal)
    {
        while (true) {
            std::map<int, RunHistory> histories;
            auto state = inspect(communicator, parts, wave, campaign->input, histories);
            on_root(communicator, [&] {
                for (int const row : state.poisonous) {
                    FinishedRun quarantined{wave.runs[static_cast<std::size_t>(row)], {}};
                    quarantined.record.status = rig::RunStatus::quarantined;
                    quarantined.record.reason = quarantine_reason(histories[quarantined.record.run]);
                    parts.store(quarantined, campaign->input, *journal);
                }
            });
            std::vector<int> poisonous(1, static_cast<int>(state.poisonous.size()));
            broadcast(communicator, poisonous);
            if (poisonous.front() == 0)
                return state;
        }
    }

    WaveWork look_at(Wave const& wave, std::vector<int>& crcs, Journal* journal)
    {
        WaveWork work;
        std::vector<int> counts(2);
        auto const state = inspect_and_quarantine(wave, journal);
        on_root(communicator, [&] {
            std::map<int, double> measured;
            for (std::size_t row = 0; row < state.shards.size(); ++row) {
                auto const& shard = state.shards[row];
                crcs.push_back(static_cast<int>(shard.crc));
                if (shard.crc == 0)
                    continue;
                if (shard.status == rig::RunStatus::finished)
                    measured[wave.runs[row].run] = shard.wall_time;
                work.clock = std::max(work.clock, shard.start_time + shard.wall_time);
                ++counts[0];
                counts[1] += rig::has_failed(shard.status);
            }
            auto const expected = expected_times(*campaign, wave, measured);
            work.seconds = expected.seconds;
            work.limits = wall_time_limits(campaign->input.run, expected);
            work.pending = longest_first(state.pending, work.seconds);
            work.suspicious = longest_first(state.suspicious, work.seconds);
        });
        broadcast(communicator, work.pending);
        broadcast(communicator, work.suspicious);
        broadcast(communicator, counts);
        broadcast(communicator, crcs);
        MPI_Bcast(&work.clock, 1, MPI_DOUBLE, 0, communicator);
        work.done = counts[0];
        work.failed = counts[1];
        broadcast(communicator, work.seconds);
        broadcast(communicator, work.limits);
        return work;
    }

    void gather_wave(Wave const& plan, WaveWork const& work, std::vector<int> const& crcs)
    {
        FinishedWave finished{plan, {crcs.begin(), crcs.end()}};
        finished.wave.groups = groups->count();
        finished.wave.wall_time = work.clock;
        gather(communicator, file, campaign->input, parts, finished);
        on_root(communicator, [&] {
            auto& wave = campaign->waves[static_cast<std::size_t>(plan.number)];
            wave = read_wave(open_campaign(file), plan.number, campaign->input);
            if (campaign->open_wave())
                parts.remove_shards(wave);
            else
                parts.remove();
        });
        share_wave(communicator, *campaign, plan.number);
    }

    //! Runs what a wave lacks, and gathers it.
    WaveEnd run(Wave wave)
    {
        std::unique_ptr<Journal> journal;
        on_root(communicator, [&] { parts.make_folder(); });
        on_all(communicator, [&] {
            if (groups->leads())
                journal = std::make_unique<Journal>(parts.folder(),
                                                    fmt::format("rank-{:04}", rank_of(communicator)));
        });
        for (int round = 0;; ++round) {
            std::vector<int> crcs;
            auto const work = look_at(wave, crcs, journal.get());
            if (work.pending.empty() && work.suspicious.empty()) {
                gather_wave(wave, work, crcs);
                return WaveEnd::complete;
            }
            if (!options.simulates || is_stop_requested(communicator))
                return WaveEnd::drained;
            if (round == 3) // a second round is due only when a shard was damaged after it was written
                throw FileError(fmt::format("{}: finished runs cannot be read back; the disk may be failing",
                                            parts.folder().string()));
            WaveRunner runner(communicator, *groups, campaign->input, parts);
            runner.run(wave, work, journal.get(), options.progress);
        }
    }

    int exceptions_before = std::uncaught_exceptions();
    Communicator communicator;
    fs::path file;
    Parts parts;
    SessionOptions options;
    StopSignals signals;
    std::unique_ptr<CampaignLock> lock; //!< on rank 0
    std::unique_ptr<PresenceMark> presence;
    std::unique_ptr<Campaign> campaign;
    std::unique_ptr<Groups> groups;
};

Session::Session(MPI_Comm communicator, fs::path const& file, SessionOptions const& options)
    : implementation_(std::make_unique<Implementation>(communicator, file, options))
{
}

Session::~Session() = default;

Campaign const& Session::campaign() const
{
    return *implementation_->campaign;
}

int Session::groups() const
{
    return implementation_->groups->count();
}

void Session::plan_wave(WavePurpose purpose, std::vector<std::vector<double>> const& points)
{
    plan_wave({.purpose = purpose, .points = points});
}

void Session::plan_wave(WavePlan const& plan)
{
    auto& self = *implementation_;
    auto& campaign = *self.campaign;
    assert(!campaign.open_wave());
    auto const number = static_cast<int>(campaign.waves.size());
    on_root(self.communicator, [&] {
        auto wave = plan_runs(campaign, plan);
        if (wave.runs.empty())
            throw InputError("a wave needs at least one design point");
        update_file(self.file, small_change + 256 * wave.runs.size(), [&](hid_t file) {
            RowWriter writer(file);
            write_plan(writer, wave, campaign.input);
        });
        campaign.waves.push_back(std::move(wave));
    });
    share_wave(self.communicator, campaign, number);
}

WaveEnd Session::run_waves()
{
    auto& self = *implementation_;
    while (auto const* open = self.campaign->open_wave())
        if (self.run(*open) == WaveEnd::drained)
            return WaveEnd::drained;
    return WaveEnd::complete;
}

void Session::store_analysis(std::vector<NamedArray> const& analysis)
{
    auto& self = *implementation_;
    auto& campaign = *self.campaign;
    auto const number = static_cast<int>(campaign.waves.size()) - 1;
    on_root(self.communicator, [&] {
        auto bytes = small_change;
        for (auto const& array : analysis)
            bytes += 4096 + 8 * array.data.size();
        update_file(self.file, bytes, [&](hid_t file) { write_analysis(file, number, analysis); });
        campaign.waves.back() = read_wave(open_campaign(self.file), number, campaign.input);
    });
    share_wave(self.communicator, campaign, number);
}

void Session::end(std::string const& reason)
{
    auto& self = *implementation_;
    auto text = reason;
    on_root(self.communicator, [&] {
        update_file(self.file, small_change,
                    [&](hid_t file) { hdf5::set_attribute(file, "/", "ended", text); });
    });
    broadcast(self.communicator, text);
    self.campaign->ended = text;
}

} // namespace demens::ensemble
