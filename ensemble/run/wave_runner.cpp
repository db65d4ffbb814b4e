#include "ensemble/run/wave_runner.hpp"

#include "demens/base/error.hpp"
#include "demens/dem/engine.hpp"
#include "ensemble/mpi/shared_counters.hpp"
#include "ensemble/progress.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/runs_in_flight.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/run/together.hpp"

#include <chrono>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <thread>

namespace demens::ensemble {
namespace {

enum Counter
{
    next_run,
    runs_done,
    runs_failed,
    microseconds_done,
    counter_count
};
std::int64_t constexpr closed = std::int64_t{1} << 40; //!< added to next_run: nothing is left to take
int constexpr no_row = -1;

void wait_patiently(MPI_Request& request)
{
    int arrived = 0;
    for (auto pause = std::chrono::microseconds(50);;
         pause = std::min(2 * pause, std::chrono::microseconds(20000))) {
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived)
            return;
        std::this_thread::sleep_for(pause);
    }
}

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
    group_ = Communicator::split(communicator, mine_);
    if (mine_ >= 0 && ranks_per_group > 1)
        team_ = std::make_unique<MpiTeam>(group_);
}

int Groups::from_first(int value) const
{
    if (!team_)
        return value;
    MPI_Request request;
    MPI_Ibcast(&value, 1, MPI_INT, 0, group_, &request);
    wait_patiently(request);
    return value;
}

void patient_barrier(MPI_Comm communicator)
{
    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    wait_patiently(request);
}

//! One pass over a list of rows: shared by `pending` (all groups) and `suspicious` (the first group).
class WaveRunner::Pass
{
  public:
    Pass(WaveRunner const& runner, Wave const& wave, WaveWork const& work, Journal* journal,
         std::FILE* progress)
        : runner_(runner), wave_(wave), work_(work), journal_(journal),
          device_(device_share(runner.communicator_, runner.input_, wave, work.pending)),
          counters_(runner.communicator_, counter_count),
          display_(progress, fmt::format("wave {} ({})", wave.number, word_for(wave.purpose))),
          begin_(Clock::now())
    {
    }

    //! Takes rows until none is left, or follows the first rank of the group, which does. The failure is this
    //! rank's own: it cannot write.
    Failure take(std::vector<int> const& rows, Journal::Company company)
    {
        if (!runner_.groups_.leads()) {
            follow();
            return {};
        }
        auto const failure = capture([&] {
            if (device_)
                return take_together(rows, company);
            while (auto const row = next_row(rows)) {
                run_row(*row, company);
                show();
            }
        });
        if (failure || StopSignals::request() != StopRequest::none)
            counters_.add(next_run, closed);
        dismiss();
        return failure;
    }

    //! Tells the ranks that follow this one that there is nothing more.
    void dismiss() { runner_.groups_.from_first(no_row); }

    //! Between two passes. Collective.
    void rewind(bool is_root)
    {
        patient_barrier(runner_.communicator_);
        if (is_root && counters_.value(next_run) < closed)
            counters_.add(next_run, -counters_.value(next_run));
        MPI_Barrier(runner_.communicator_);
    }

    void finish()
    {
        if (rank_of(runner_.communicator_) == 0)
            display_.finish(state());
    }

  private:
    using Clock = std::chrono::steady_clock;

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

    //! The next row that nobody has; none when all are taken or a stop is asked for.
    std::optional<int> next_row(std::vector<int> const& rows)
    {
        if (StopSignals::request() != StopRequest::none)
            return {};
        auto const i = static_cast<std::size_t>(counters_.add(next_run, 1));
        return i < rows.size() ? std::optional(rows[i]) : std::nullopt;
    }

    //! Takes rows for a device, which does many at once.
    void take_together(std::vector<int> const& rows, Journal::Company company)
    {
        RunsInFlight flight(*journal_, wave_);
        try {
            fly(rows, company, flight);
        } catch (FileError const&) {
            capture([&] { flight.give_up(); }); // not the runs' fault
            throw;
        }
    }

    void fly(std::vector<int> const& rows, Journal::Company company, RunsInFlight& flight)
    {
        auto share = *device_;
        if (company == Journal::Company::alone)
            share.runs = 1;
        auto together = std::make_unique<RunsTogether>(runner_.input_, share);
        std::deque<int> again; // taken, and given up for want of memory
        bool is_any_left = true;
        while (true) {
            while (together->has_room() && (is_any_left || !again.empty())) {
                auto const row = again.empty() ? next_row(rows) : std::optional(again.front());
                if (!again.empty())
                    again.pop_front();
                else if (!(is_any_left = row.has_value()))
                    break;
                flight.start(*row, company, work_.clock + elapsed());
                together->begin(*row, wave_.runs[static_cast<std::size_t>(*row)]);
            }
            if (together->is_empty())
                return;
            flight.note_signals();
            try {
                for (auto& one : together->advance()) {
                    one.run.record.start_time = flight.end(one.row);
                    one.run.record.group = runner_.groups_.mine();
                    keep(one.row, one.run);
                }
            } catch (std::bad_alloc const&) {
                again = give_up_for_memory(*together, flight, share.runs == 1);
                share.runs = (share.runs + 1) / 2;
                together.reset(); // its memory first
                together = std::make_unique<RunsTogether>(runner_.input_, share);
            }
            counters_.progress();
            show();
            if (StopSignals::should_stop_run()) {
                flight.give_up();
                return;
            }
        }
    }

    //! Rows that are to begin again with fewer slots; where there is but one, its run has failed.
    std::deque<int> give_up_for_memory(RunsTogether const& together, RunsInFlight& flight, bool has_one_slot)
    {
        auto again = flight.give_up();
        if (has_one_slot)
            for (int const row : together.rows()) {
                std::erase(again, row);
                keep(row, without_memory(row));
            }
        return again;
    }

    FinishedRun without_memory(int row) const
    {
        return finished_run(runner_.input_, wave_.runs[static_cast<std::size_t>(row)],
                            {.status = rig::RunStatus::error, .reason = "not enough memory on the device"},
                            0);
    }

    void keep(int row, FinishedRun const& finished)
    {
        runner_.parts_.store(finished, runner_.input_, *journal_);
        counters_.add(runs_done, 1);
        counters_.add(runs_failed, rig::has_failed(finished.record.status));
        counters_.add(microseconds_done, std::llround(1e6 * work_.seconds[static_cast<std::size_t>(row)]));
    }

    //! Only the first rank of the group keeps what comes out; it comes out alike on all.
    void follow()
    {
        for (int row; (row = runner_.groups_.from_first(no_row)) != no_row;)
            try {
                simulate(row);
            } catch (rig::RunInterrupted const&) { // so is the first rank, and it will say what comes next
            }
    }

    void run_row(int row, Journal::Company company)
    {
        auto const& plan = wave_.runs[static_cast<std::size_t>(row)];
        journal_->start(plan.run, company);
        runner_.groups_.from_first(row);
        try {
            double const start_time = work_.clock + elapsed();
            auto finished = simulate_noting_crashes(row);
            finished.record.group = runner_.groups_.mine();
            finished.record.start_time = start_time;
            keep(row, finished);
        } catch (rig::RunInterrupted const&) {
            journal_->drain(plan.run);
            return;
        } catch (FileError const&) {
            capture([&] { journal_->drain(plan.run); }); // not the run's fault
            throw;
        }
    }

    FinishedRun simulate_noting_crashes(int row)
    {
        auto const& plan = wave_.runs[static_cast<std::size_t>(row)];
        CrashNote const note(journal_->descriptor(), journal_->stop_line(plan.run),
                             [&](int signal) { return journal_->crash_line(plan.run, signal); });
        return simulate(row);
    }

    FinishedRun simulate(int row)
    {
        rig::RunHooks hooks;
        hooks.team = runner_.groups_.team();
        hooks.wall_time_limit = work_.limits[static_cast<std::size_t>(row)];
        hooks.should_stop = [this] {
            counters_.progress();
            show();
            return StopSignals::should_stop_run();
        };
        return execute(runner_.input_, wave_.runs[static_cast<std::size_t>(row)], hooks);
    }

    ProgressState state()
    {
        ProgressState state;
        state.runs = static_cast<int>(wave_.runs.size());
        state.done = work_.done + static_cast<int>(counters_.value(runs_done));
        state.failed = work_.failed + static_cast<int>(counters_.value(runs_failed));
        for (auto const* rows : {&work_.pending, &work_.suspicious})
            for (int const row : *rows)
                state.work += work_.seconds[static_cast<std::size_t>(row)];
        state.work_done = 1e-6 * static_cast<double>(counters_.value(microseconds_done));
        state.groups = runner_.groups_.count();
        state.elapsed = elapsed();
        return state;
    }

    void show()
    {
        if (rank_of(runner_.communicator_) == 0)
            display_.update(state());
    }

    WaveRunner const& runner_;
    Wave const& wave_;
    WaveWork const& work_;
    Journal* journal_;
    std::optional<DeviceShare> device_; //!< none: processors
    SharedCounters counters_;
    ProgressDisplay display_;
    Clock::time_point begin_;
};

WaveRunner::WaveRunner(MPI_Comm communicator, Groups const& groups, CampaignInput const& input,
                       Parts const& parts)
    : communicator_(communicator), groups_(groups), input_(input), parts_(parts)
{
}

void WaveRunner::run(Wave const& wave, WaveWork const& work, Journal* journal, std::FILE* progress)
{
    Pass pass(*this, wave, work, journal, progress);
    Failure failure;
    if (groups_.mine() >= 0)
        failure = pass.take(work.pending, Journal::Company::others);
    pass.rewind(rank_of(communicator_) == 0);
    if (groups_.mine() == 0) {
        if (failure)
            pass.dismiss();
        else
            failure = pass.take(work.suspicious, Journal::Company::alone);
    }
    patient_barrier(communicator_);
    pass.finish();
    agree(communicator_, failure);
}

} // namespace demens::ensemble
