#pragma once

#include "demens/base/options.hpp"
#include "demens/contact/model.hpp"
#include "demens/dem/energy.hpp"
#include "demens/dem/team.hpp"
#include "demens/grain/grains.hpp"
#include "demens/observe/snapshot.hpp"
#include "demens/rig/engine_choice.hpp"
#include "demens/shape/size_distribution.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demens::rig {

//! How a run ended. Everything but `finished` keeps the run out of fits.
enum class RunStatus
{
    not_run = 0,
    finished = 1,
    not_a_number = 2, //!< a position or force became NaN or infinite
    escaped = 3,      //!< particles left the domain
    overlapping = 4,  //!< overlap beyond the limit
    timed_out = 5,    //!< simulated or wall time ran out before the end criterion
    error = 6,        //!< any other reason; see the reason text
    quarantined = 7,  //!< begun twice and never ended
    unbalanced = 8,   //!< the energy ledger does not close
    dropped = 9       //!< somebody has taken it out of the campaign
};
inline constexpr int run_statuses = 10;
char const* name_of(RunStatus status);
//! Whether the run came to a bad end: something is wrong where it was simulated.
constexpr bool has_failed(RunStatus status)
{
    return status != RunStatus::not_run && status != RunStatus::finished && status != RunStatus::dropped;
}

//! What a response tells of.
enum class ResponseKind
{
    quantity, //!< something that can be measured
    accuracy  //!< how well another one is known or met: nothing to measure
};

//! A scalar that a rig measures.
struct ResponseInfo
{
    std::string name;  //!< key in a campaign file; carries the unit
    std::string units; //!< for the `units` attribute
    std::string doc;   //!< one line
    ResponseKind kind = ResponseKind::quantity;
};

//! Columns of equal length over the first one: the time [s] of a time series, the axis of a profile.
struct Series
{
    std::vector<std::string> names, units; //!< one per column
    std::vector<std::vector<double>> columns;

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    //! The column of that name; it must be there.
    std::vector<double> const& column(std::string const& name) const;
};

//! A quantity over an axis at one moment, or its mean over some time, e.g. the height of a surface over x.
struct Profile
{
    std::string name, doc;
    Series curve; //!< two columns, axis and quantity; NaN where there is none
};

using observe::Snapshot;

//! What a rig gives back; always complete, also when the run failed.
struct RunResult
{
    RunStatus status = RunStatus::not_run;
    std::string reason = {};            //!< why it did not finish; empty when it did
    std::vector<double> responses = {}; //!< in the order of `responses_of`; NaN where not reached
    Series series = {};
    std::vector<Profile> profiles = {};
    std::vector<Snapshot> snapshots = {}; //!< the rig's few landmarks
    double simulated_time = 0;            //!< [s]
    std::int64_t steps = 0;
    std::int64_t particles = 0;
    std::optional<dem::EnergyLedger> energy = {}; //!< at the end, of a run with the ledger
};

//! Contents of the files that an input names, by their names as its author wrote them.
using Files = std::map<std::string, std::shared_ptr<std::string const>>;

//! Everything that determines one run's result.
struct RunInput
{
    contact::Model model;
    std::map<std::string, shape::SizeDistribution> size_distributions;
    //! Of the distributions whose grains are not spheres, by their names.
    std::map<std::string, grain::ShapeMixture> shapes_of_sizes = {};
    std::map<std::string, grain::GrainShape> shapes = {}; //!< that an experiment may name for one grain
    OptionValues experiment;                              //!< checked values of the rig's options and tables
    std::uint64_t seed = 0;
    Files files = {};
    EngineChoice engine = EngineChoice::cpu; //!< others give other packings
};

struct RunState; // programme/programme_run.hpp

//! How far a run is.
struct RunProgress
{
    double share;       //!< simulated time over that which is expected; may exceed 1
    std::string moment; //!< e.g. `in stage "flow" at 0.85 s`
};

//! What the caller wants while a run goes on; nothing here but the number of ranks in a team changes the
//! result.
struct RunHooks
{
    std::function<void(Snapshot const&)> on_frame = {}; //!< called every `frame_interval` of simulated time
    double frame_interval = 0;                          //!< [s]; 0: never
    std::function<bool()> should_stop = {};             //!< polled about every 0.1 s; true ends the run early
    //! Told about every 0.1 s, by rigs that are programmes.
    std::function<void(RunProgress const&)> on_progress = {};
    double wall_time_limit = 0; //!< [s]; 0: none
    //! The ranks that simulate the run together; null: this one alone. All of them call the rig, with hooks
    //! that are set alike, and get the same result.
    dem::Team* team = nullptr;
    //! Called where a stage begins, but the first, with what the run can be gone on with; of rigs that are
    //! programmes.
    std::function<void(RunState const&, std::string const& stage)> on_stage = {};
    RunState const* from = nullptr; //!< of the same run, which is gone on with; null: from its beginning
};

//! A run that was stopped from outside; it left no result and must be run again.
class RunInterrupted : public std::exception
{
};

struct Programme; // programme/programme.hpp

//! A kind of test apparatus: what it needs, what it measures, how it runs. Of a rig that is described, all
//! that follows from the description is made by `described`.
struct RigInfo
{
    std::string name;                         //!< as in `rig = "drawdown"`
    std::string doc;                          //!< one line
    std::vector<OptionSpec> options;          //!< keys of its `[[experiment]]` table
    std::vector<TableSpec> tables = {};       //!< tables inside its `[[experiment]]` table
    std::vector<ResponseInfo> responses = {}; //!< of every experiment
    //! Further ones that an experiment asks for.
    std::function<std::vector<ResponseInfo>(OptionValues const&)> asked_responses = {};
    //! Everything that can be wrong with an input, checked before any run. \throws InputError
    std::function<void(RunInput const&)> check = {};
    //! What is doubtful about an input that can run. \throws InputError for an engine that cannot run it.
    std::function<std::vector<std::string>(RunInput const&)> warnings = {};
    //! Predicted cost [steps of a sphere].
    std::function<double(RunInput const&)> predict_cost = {};
    //! Simulates. Does not throw for a failed run. \throws RunInterrupted
    std::function<RunResult(RunInput const&, RunHooks const&)> run = {};
    //! The run as a programme of stages and readings. \throws InputError
    std::function<Programme(RunInput const&)> describe = {};
};

//! The rig with all that follows from its description: check, warnings, cost and run.
RigInfo described(RigInfo rig);

//! What an experiment of the rig measures, in the order of RunResult::responses.
std::vector<ResponseInfo> responses_of(RigInfo const& rig, OptionValues const& experiment);

//! All rigs, the one list of them.
std::vector<RigInfo> const& all_rigs();
//! The rig of that name, or null.
RigInfo const* find_rig(std::string const& name);

} // namespace demens::rig
