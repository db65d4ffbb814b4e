#include "ensemble/run/wave_runner.hpp"

#include "demens/base/error.hpp"
#include "demens/dem/engine.hpp"
#include "ensemble/mpi/patience.hpp"
#include "ensemble/progress.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/progress_notes.hpp"
#include "ensemble/run/runs_in_flight.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/run/together.hpp"
#include "ensemble/run/work_queue.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace demens::ensemble {
namespace {

int constexpr nothing_more = -1, next_wave = -2; //!< told in place of a run

} // namespace

void require_engine(RunOptions const& run)
{
    if (run.engine == rig::EngineChoice::cuda && !dem::is_present(dem::EngineKind::cuda))
        throw InputError(
            "run.engine = \"cuda\", and this process sees no CUDA device; start where there is one, "
            "or make the campaign with \"auto\" or \"cpu\"");
}

Groups::Groups(MPI_Comm communicator, int ranks_per_group)
{
    int const size = size_of(communicator), rank = rank_of(communicator);
    if (ranks_per_group < 1 || ranks_per_group > size)
        throw InputError(
            fmt::format("run.ranks_per_group = {}, but the program runs on {} rank{}: give it from 1 to {}, "
                        "or start more ranks (mpirun -n)",
                        ranks_per_group, size, size == 1 ? "" : "s", size));
    count_ = size / ranks_per_group;
    mine_ = rank / ranks_per_group < count_ ? rank / ranks_per_group : -1;
    all_ = Communicator::split(communicator, mine_ >= 0 ? 0 : -1);
    group_ = Communicator::split(communicator, mine_);
    if (mine_ >= 0 && ranks_per_group > 1)
        team_ = std::make_unique<MpiTeam>(group_);
}

int Groups::from_first(int value) const
{
    if (!team_)
        return value;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(&value, 1, MPI_INT, 0, group_, &request);
    wait_patiently(request);
    return value;
}

//! One look at a queue of runs by this rank, which has a group.
class WaveRunner::Pass
{
  public:
    Pass(WaveRunner const& runner, std::deque<QueuedWave> waves, Journal::Company company,
         std::optional<DeviceShare> const& device, Journal* journal, std::FILE* progress,
         Successor const& successor)
        : runner_(runner), company_(company), device_(device), journal_(journal), progress_(progress),
          successor_(successor),
          queue_(runner.groups_.all(), runner.input_, std::move(waves), static_cast<bool>(successor)),
          told_(queue_.known()), is_root_(rank_of(runner.groups_.all()) == 0), begin_(Clock::now())
    {
        show_front();
    }

    //! Takes runs until none is left, or follows the first rank of the group, which does. The failure is this
    //! rank's own: it cannot write.
    Failure take()
    {
        if (!runner_.groups_.leads()) {
            follow();
            return {};
        }
        auto const failure = capture([&] { device_ ? take_together() : take_one_by_one(); });
        if (failure)
            queue_.close();
        tell_of_waves();
        runner_.groups_.from_first(nothing_more);
        return failure ? failure : failure_;
    }

    void finish()
    {
        queue_.finish();
        if (display_)
            display_->finish(state());
    }

  private:
    using Clock = std::chrono::steady_clock;

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

    //! The next run, if there is one now. `over_` says whether one can still come.
    std::optional<Place> next()
    {
        if (StopSignals::request() != StopRequest::none) {
            queue_.close();
            over_ = true;
        }
        if (over_)
            return {};
        auto const place = queue_.take();
        over_ = !place && queue_.is_over();
        return place;
    }

    void take_one_by_one()
    {
        for (Patience patience; !over_;) {
            attend();
            if (auto const place = next()) {
                run_place(*place);
                patience = {};
            } else if (!over_) {
                patience.pause();
            }
        }
    }

    //! What rank 0 does between the looks of a simulation.
    void attend()
    {
        queue_.progress();
        if (!is_root_)
            return;
        if (display_)
            display_->update(state());
        if (!successor_ || failure_ || StopSignals::request() != StopRequest::none)
            return;
        while (queue_.is_front_done()) {
            display_->finish(state());
            failure_ = capture([&] { queue_.settle(successor_(queue_.wave(queue_.front()))); });
            if (failure_)
                return queue_.close();
            show_front();
        }
    }

    //! Takes runs for a device, which does many at once.
    void take_together()
    {
        RunsInFlight flight(*journal_);
        try {
            fly(flight);
        } catch (FileError const&) {
            capture([&] { flight.give_up(); }); // not the runs' fault
            throw;
        }
    }

    void fly(RunsInFlight& flight)
    {
        auto share = *device_;
        if (company_ == Journal::Company::alone)
            share.runs = 1;
        auto together = std::make_unique<RunsTogether>(runner_.input_, share);
        std::deque<Place> again;       // taken, and given up for want of memory
        auto next_look = Clock::now(); // rank 0 may be slow to answer, and the device must not wait for it
        for (Patience patience;;) {
            while (together->has_room()) {
                std::optional<Place> place;
                if (!again.empty()) {
                    place = again.front();
                    again.pop_front();
                } else if (Clock::now() >= next_look) {
                    place = next();
                    if (!place)
                        next_look = Clock::now() + std::chrono::milliseconds(500);
                }
                if (!place)
                    break;
                auto const& plan = queue_.plan_of(*place);
                tell_begin(*place);
                flight.start(*place, plan.run, company_, start_time(*place));
                together->begin(*place, plan);
            }
            attend();
            if (together->is_empty()) {
                if (over_)
                    return;
                patience.pause(); // a wave may follow
                continue;
            }
            patience = {};
            flight.note_signals();
            try {
                for (auto& one : together->advance()) {
                    one.run.record.start_time = flight.end(one.key);
                    one.run.record.group = runner_.groups_.mine();
                    keep(one.key, one.run);
                }
            } catch (std::bad_alloc const&) {
                again = give_up_for_memory(*together, flight, share.runs == 1);
                share.runs = (share.runs + 1) / 2;
                together.reset(); // its memory first
                together = std::make_unique<RunsTogether>(runner_.input_, share);
            }
            if (StopSignals::should_stop_run()) {
                flight.give_up();
                return;
            }
        }
    }

    //! Those that are to begin again with fewer slots; where there is but one, its run has failed.
    std::deque<Place> give_up_for_memory(RunsTogether const& together, RunsInFlight& flight,
                                         bool has_one_slot)
    {
        auto again = flight.give_up();
        if (has_one_slot)
            for (Place const place : together.keys()) {
                std::erase(again, place);
                keep(place, without_memory(place));
            }
        return again;
    }

    FinishedRun without_memory(Place place) const
    {
        return finished_run(runner_.input_, queue_.plan_of(place),
                            {.status = rig::RunStatus::error, .reason = "not enough memory on the device"},
                            0);
    }

    void keep(Place place, FinishedRun const& finished)
    {
        runner_.parts_.store(finished, runner_.input_, *journal_);
        tell_end(finished.record);
        queue_.count(place, rig::has_failed(finished.record.status));
    }

    void tell_begin(Place place) const
    {
        if (!spdlog::should_log(spdlog::level::debug))
            return;
        auto const& plan = queue_.plan_of(place);
        auto const row = static_cast<std::size_t>(queue_.row_of(place));
        auto const& work = queue_.wave_of(place).work;
        spdlog::debug("run {} of {}, point {}, begins on group {}; expected {}", plan.run,
                      experiment_of(plan), plan.point, runner_.groups_.mine(),
                      duration_text(work.seconds[row]));
    }

    void tell_end(RunRecord const& run) const
    {
        spdlog::debug("run {} of {} is {} after {:.2f} s{}{}", run.run, experiment_of(run),
                      rig::name_of(run.status), run.wall_time, run.reason.empty() ? "" : ": ", run.reason);
    }

    std::string const& experiment_of(RunRecord const& run) const
    {
        return runner_.input_.experiments[static_cast<std::size_t>(run.experiment)].name;
    }

    //! Only the first rank of the group keeps what comes out; it comes out alike on all.
    void follow()
    {
        for (int told = nothing_more; (told = runner_.groups_.from_first(nothing_more)) != nothing_more;)
            if (told == next_wave)
                queue_.receive();
            else
                try {
                    simulate(told);
                } catch (rig::RunInterrupted const&) { // so is the first rank, and it says what comes next
                }
    }

    //! The followers of this rank learn of the waves that it has learnt of.
    void tell_of_waves()
    {
        for (; told_ < queue_.known(); ++told_)
            runner_.groups_.from_first(next_wave);
    }

    //! [s] since its wave began; of a wave that was added, since the first one of the queue did.
    double start_time(Place place) const { return queue_.wave_of(place).work.clock + elapsed(); }

    void run_place(Place place)
    {
        int const run = queue_.plan_of(place).run;
        tell_begin(place);
        journal_->start(run, company_);
        tell_of_waves();
        runner_.groups_.from_first(place);
        try {
            double const begin = start_time(place);
            auto finished = simulate_noting_crashes(place);
            finished.record.group = runner_.groups_.mine();
            finished.record.start_time = begin;
            keep(place, finished);
        } catch (rig::RunInterrupted const&) {
            spdlog::debug("run {} is given up: asked to stop", run);
            journal_->drain(run);
        } catch (FileError const&) {
            capture([&] { journal_->drain(run); }); // not the run's fault
            throw;
        }
    }

    FinishedRun simulate_noting_crashes(Place place)
    {
        int const run = queue_.plan_of(place).run;
        CrashNote const note(journal_->descriptor(), journal_->stop_line(run),
                             [&](int signal) { return journal_->crash_line(run, signal); });
        return simulate(place);
    }

    FinishedRun simulate(Place place)
    {
        auto const row = static_cast<std::size_t>(queue_.row_of(place));
        rig::RunHooks hooks;
        hooks.team = runner_.groups_.team();
        hooks.wall_time_limit = queue_.wave_of(place).work.limits[row];
        hooks.should_stop = [this] {
            attend();
            return StopSignals::should_stop_run();
        };
        if (journal_)
            hooks.on_progress = progress_notes(*journal_, queue_.plan_of(place).run);
        return execute(runner_.input_, queue_.plan_of(place), hooks);
    }

    //! From now on the first wave that is not settled is shown.
    void show_front()
    {
        display_.reset();
        if (!is_root_ || queue_.front() == queue_.known())
            return;
        auto const& wave = queue_.wave(queue_.front()).wave;
        display_.emplace(progress_, fmt::format("wave {} ({})", wave.number, word_for(wave.purpose)));
        shown_since_ = elapsed();
    }

    ProgressState state()
    {
        auto const& [wave, work] = queue_.wave(queue_.front());
        auto const done = queue_.done(queue_.front());
        ProgressState state;
        state.runs = static_cast<int>(wave.runs.size());
        state.done = work.done + done.runs;
        state.failed = work.failed + done.failed;
        for (int const row : work.pending)
            state.work += work.seconds[static_cast<std::size_t>(row)];
        state.work_done = done.seconds;
        state.groups = runner_.groups_.count();
        state.elapsed = elapsed() - shown_since_;
        return state;
    }

    WaveRunner const& runner_;
    Journal::Company company_;
    std::optional<DeviceShare> const& device_; //!< none: processors
    Journal* journal_;
    std::FILE* progress_;
    Successor const& successor_;
    WorkQueue queue_;
    int told_; //!< waves of which this rank's followers know
    bool is_root_;
    bool over_ = false;                      //!< there is nothing to take, now or later
    Failure failure_;                        //!< of the successor
    std::optional<ProgressDisplay> display_; //!< of rank 0
    double shown_since_ = 0;                 //!< [s]
    Clock::time_point begin_;
};

WaveRunner::WaveRunner(MPI_Comm communicator, Groups const& groups, CampaignInput const& input,
                       Parts const& parts)
    : communicator_(communicator), groups_(groups), input_(input), parts_(parts)
{
}

void WaveRunner::run(std::deque<QueuedWave> waves, Journal* journal, std::FILE* progress,
                     Successor const& successor)
{
    auto& first = waves.front();
    bool const alone = first.work.pending.empty();
    if (alone)
        first.work.pending = first.work.suspicious;
    auto const device = device_share(communicator_, input_, first.wave, first.work.pending);
    Failure failure;
    if (groups_.mine() >= 0) {
        Pass pass(*this, std::move(waves), alone ? Journal::Company::alone : Journal::Company::others, device,
                  journal, progress, successor);
        if (!alone || groups_.mine() == 0)
            failure = pass.take();
        pass.finish();
    }
    patient_barrier(communicator_);
    agree(communicator_, failure);
}

} // namespace demens::ensemble
