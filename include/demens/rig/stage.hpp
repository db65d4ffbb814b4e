#pragma once

#include "demens/dem/simulation.hpp"
#include "demens/rig/rig.hpp"

#include <chrono>
#include <exception>
#include <functional>
#include <string>

namespace demens::rig {

//! A run cannot go on: caught by `run_guarded`, which makes it the status of the run.
class RunFailure : public std::exception
{
  public:
    RunFailure(RunStatus status, std::string reason) : status_(status), reason_(std::move(reason)) {}
    RunStatus status() const { return status_; }
    char const* what() const noexcept override { return reason_.c_str(); }

  private:
    RunStatus status_;
    std::string reason_;
};

//! Drives a simulation through the stages of a rig: steps, health, time limits, frames and the caller's
//! hooks.
class StageRunner
{
  public:
    StageRunner(dem::Simulation& simulation, RunHooks const& hooks, double check_interval);

    //! Runs until `done` holds, asked every check interval [s]; `observe`, if given, is called just before.
    //! \throws RunFailure after `longest` [s] of simulated time, on a health failure or when wall time runs
    //! out. \throws RunInterrupted
    void run_until(std::string const& stage, double longest, std::function<bool()> const& done,
                   std::function<void()> const& observe = {});
    //! Runs for a simulated time [s].
    void run_for(std::string const& stage, double duration, std::function<void()> const& observe = {});

  private:
    void check(std::string const& stage);
    void write_frames(std::string const& stage);
    //! Whether any rank of the team says so: what depends on clocks and signals must end all or none.
    bool is_agreed(bool here) const;

    dem::Simulation& simulation_;
    RunHooks const& hooks_;
    std::int64_t steps_per_check_;
    double next_frame_;
    std::chrono::steady_clock::time_point started_;
};

//! Particles and walls now, sorted by id.
Snapshot take_snapshot(dem::Simulation const& simulation, std::string name);

//! What every run says about itself at its end: steps, time and the energy ledger, if there is one.
void record_end(dem::Simulation& simulation, RunResult& result);

//! Calls `body(result)` and turns what it throws into the status and reason of the run; responses that were
//! not reached are NaN. \throws RunInterrupted
RunResult run_guarded(std::size_t responses, std::function<void(RunResult&)> const& body);

} // namespace demens::rig
