#pragma once

#include "demens/dem/state_record.hpp"
#include "demens/rig/programme/programme.hpp"

#include <exception>

namespace demens::rig {

//! A run cannot go on: what a stage or a reading throws to make this the status of the run.
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

//! A run as it can be kept: the state of its simulation, and where it is in its programme.
struct RunState
{
    dem::StateRecord simulation;
    Progress progress;

    //! All of it as one record, which can be written to a file.
    dem::StateRecord record() const;
    //! \throws InputError for a record that is not of a run
    static RunState from_record(dem::StateRecord record);
};

//! A run of a programme, which is done piece by piece: many can be held at once, and each can be left at any
//! time. With a team, all its ranks make the same calls.
class ProgrammeRun
{
  public:
    //! \param team who simulates it together; null: this rank alone
    //! \param batch where it takes a slot if its engine is that of a device; null: a device to itself
    ProgrammeRun(Programme programme, dem::Team* team, dem::DeviceBatch* batch = nullptr);
    //! Goes on with a run of the same programme that was left, with the same bits. \throws InputError
    ProgrammeRun(Programme programme, dem::Team* team, RunState const& state);

    //! Does so many time steps or less, with all looks and changes of stage that come on the way; returns
    //! when they are done or the run is over. What goes wrong in it is the run's status.
    void advance(std::int64_t steps);
    //! The same in two parts, for who advances many at once. All that is due now; returns the steps that the
    //! simulation is then to do before the next look, 0 when the run is over.
    std::int64_t prepare();
    //! So many of them have been done.
    void has_advanced(std::int64_t steps);
    bool has_begun() const { return bench_ && bench_->simulation.steps_done() > 0; }
    //! Of a run that is prepared.
    dem::Simulation& simulation() { return bench_->simulation; }
    bool is_over() const { return status_ != RunStatus::not_run; }
    //! To go on later or elsewhere; the run has begun and is not over.
    RunState save() { return {bench_->simulation.save(), bench_->progress}; }
    //! Ends the run from outside.
    void fail(RunStatus status, std::string reason);
    //! Called at every look with the stage's name, before anything is read.
    void watch(std::function<void(Bench&, std::string const&)> watcher) { watcher_ = std::move(watcher); }

    double time() const { return bench_ ? bench_->simulation.time() : 0; } //!< [s]
    //! "in stage "fill" at 0.1000 s", for messages.
    std::string moment() const;
    //! What it has given so far.
    RunResult result();

  private:
    //! Calls, and makes what goes wrong the run's status.
    template <class Call>
    void guarded(Call const& call);
    void build();
    //! Whose coefficients hold from now on.
    void set_model(contact::Model const& model);
    //! Brings coefficients that drift to the present; readers see them from the next step on.
    void drift();
    void begin_stage();
    void look();
    void sample(Look& look);
    void add_profiles(Look& look, ProfileReading::Over over);
    bool is_stage_over(Look& look);
    void end_stage(Look& look);
    Stage const& stage() const { return programme_.stages[bench_->progress.stage]; }

    Programme programme_;
    dem::Team* team_;
    dem::DeviceBatch* batch_;
    std::optional<Bench> bench_;             //!< none before the first step
    std::optional<contact::Model> drifting_; //!< as given at the beginning; none: no coefficient drifts
    std::function<void(Bench&, std::string const&)> watcher_;
    RunStatus status_ = RunStatus::not_run;
    std::string reason_;
};

//! Runs a programme to its end, with what the caller wants meanwhile. \throws RunInterrupted
RunResult run_programme(Programme programme, RunHooks const& hooks);

//! Particles and walls now, in the order of their ids; forces, masses and materials too.
Snapshot take_snapshot(dem::Simulation& simulation, std::string name);

} // namespace demens::rig
