#include "ensemble/session.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/run/wave_runner.hpp"
#include "ensemble/shared_campaign.hpp"
#include "ensemble/storage/lock.hpp"
#include "ensemble/wave_keeper.hpp"

#include <algorithm>
#include <cassert>
#include <deque>
#include <exception>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

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
    Implementation(MPI_Comm parent, fs::path path, SessionOptions const& session_options)
        : communicator(Communicator::duplicate(parent)), file(std::move(path)), parts(file),
          options(session_options)
    {
        on_root(communicator, [&] {
            open_campaign(file); // a wrong file is refused before anything is made beside it
            lock = std::make_unique<CampaignLock>(file, CampaignLock::Kind::session);
            fs::remove(beside(file, ".new"));
        });
        on_all(communicator, [&] { presence = std::make_unique<PresenceMark>(file); });
        campaign = std::make_unique<Campaign>(read_for_all(communicator, file, options.rigs));
        on_all(communicator, [&] { require_engine(campaign->input.run); });
        keeper = std::make_unique<WaveKeeper>(file, *campaign, parts);
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

    std::unique_ptr<Journal> begin_journal() const
    {
        std::unique_ptr<Journal> journal;
        on_root(communicator, [&] { parts.make_folder(); });
        on_all(communicator, [&] {
            if (groups->leads())
                journal = std::make_unique<Journal>(parts.folder(),
                                                    fmt::format("rank-{:04}", rank_of(communicator)));
        });
        return journal;
    }

    bool is_last(int wave) const { return wave + 1 == static_cast<int>(campaign->waves.size()); }

    //! Runs what open waves lack, and gathers them.
    WaveEnd run(Foresight const& foresight)
    {
        auto const journal = begin_journal();
        std::map<int, int> rounds; // of each wave
        while (auto const* open = campaign->open_wave()) {
            int const number = open->number;
            auto const seen = keeper->look_at(communicator, *open, journal.get());
            if (seen.work.is_done()) {
                keeper->gather(communicator, number, seen, groups->count());
                continue;
            }
            if (!options.simulates || is_stop_requested(communicator))
                return WaveEnd::drained;
            // Two are due: what can run beside others, and what must not; more only when a shard was damaged
            // after it was written.
            if (rounds[number]++ == 4)
                throw FileError(fmt::format("{}: finished runs cannot be read back; the disk may be failing",
                                            parts.folder().string()));
            WaveRunner runner(communicator, *groups, campaign->input, parts);
            bool const can_look_ahead =
                is_last(number) || (is_last(number + 1) && !is_complete(campaign->waves.back()));
            keeper->groups_begin(number);
            if (foresight && can_look_ahead && seen.work.suspicious.empty())
                run_looking_ahead(runner, {*open, seen.work}, journal.get(), foresight);
            else
                runner.run({{*open, seen.work}}, journal.get(), options.progress);
            keeper->groups_end();
        }
        return WaveEnd::complete;
    }

    //! The last wave, or the last two, and those that are planned meanwhile.
    void run_looking_ahead(WaveRunner& runner, QueuedWave first, Journal* journal, Foresight const& foresight)
    {
        if (is_last(first.wave.number))
            look_ahead(communicator, foresight);
        int const before = std::max(0, first.wave.number - 1);
        std::deque<QueuedWave> queue{std::move(first)};
        if (!is_last(queue.front().wave.number)) {
            auto const& second = campaign->waves.back();
            auto const seen = keeper->look_at(communicator, second, journal);
            if (!seen.work.suspicious.empty())
                return runner.run(std::move(queue), journal, options.progress);
            queue.push_back({second, seen.work});
        }
        double clock = 0; // all runs of the queue count their time from the same moment
        for (auto const& queued : queue)
            clock = std::max(clock, queued.work.clock);
        for (auto& queued : queue)
            queued.work.clock = clock;
        runner.run(std::move(queue), journal, options.progress,
                   [&](QueuedWave const& over) { return successor(over, journal, foresight); });
        share_waves_from(before);
    }

    //! On rank 0 alone, while the others simulate: gathers a wave whose runs are over, and plans the next but
    //! one.
    std::optional<QueuedWave> successor(QueuedWave const& over, Journal* journal, Foresight const& foresight)
    {
        int const number = over.wave.number;
        auto const seen = keeper->look_at(MPI_COMM_SELF, over.wave, journal);
        if (!seen.work.is_done())
            return {}; // all ranks will look at it
        keeper->gather(MPI_COMM_SELF, number, seen, groups->count());
        if (is_last(number) || !look_ahead(MPI_COMM_SELF, foresight))
            return {};
        auto const& next = campaign->waves.back();
        auto work = keeper->look_at(MPI_COMM_SELF, next, journal).work;
        work.clock = over.work.clock;
        return QueuedWave{next, std::move(work)};
    }

    //! Stores analyses of complete waves and plans the wave after the open one, if that can be. Collective
    //! over all ranks or rank 0 alone.
    bool look_ahead(MPI_Comm who, Foresight const& foresight)
    {
        LookAhead ahead;
        std::vector<int> sizes(2);
        on_root(who, [&] {
            ahead = foresight(*campaign);
            sizes = {static_cast<int>(ahead.analyses.size()), ahead.next.has_value()};
        });
        broadcast(who, sizes);
        ahead.analyses.resize(static_cast<std::size_t>(sizes[0]));
        for (auto& [wave, analysis] : ahead.analyses) {
            std::vector<int> number{wave};
            broadcast(who, number);
            keeper->store_analysis(who, number[0], analysis);
        }
        if (sizes[1])
            keeper->plan(who, ahead.next.value_or(WavePlan{}));
        return sizes[1] != 0;
    }

    //! What rank 0 has changed alone.
    void share_waves_from(int first)
    {
        std::vector<int> waves(1, static_cast<int>(campaign->waves.size()));
        broadcast(communicator, waves);
        for (int number = first; number < waves[0]; ++number)
            share_wave(communicator, *campaign, number);
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
    std::unique_ptr<WaveKeeper> keeper;
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
    assert(!implementation_->campaign->open_wave());
    implementation_->keeper->plan(implementation_->communicator, plan);
}

WaveEnd Session::run_waves(Foresight const& foresight)
{
    return implementation_->campaign->open_wave() ? implementation_->run(foresight) : WaveEnd::complete;
}

void Session::store_analysis(int wave, std::vector<NamedArray> const& analysis)
{
    implementation_->keeper->store_analysis(implementation_->communicator, wave, analysis);
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
