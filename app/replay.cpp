#include "app/checkpoint.hpp"
#include "app/checks.hpp"
#include "app/command.hpp"
#include "app/simulated_again.hpp"
#include "demens/base/error.hpp"
#include "demens/observe/vtk_frames.hpp"
#include "ensemble/mpi/mpi_team.hpp"
#include "ensemble/session.hpp"

#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace demens::cli {
namespace {

struct ReplayOptions
{
    std::string file, frames, checkpoints, from;
    int run = 0;
    double frame_interval = 0.02; //!< [s]
    bool check = false;
};

//! The ranks that this program was started on, when a campaign gives several to a run: only as many get the
//! same bits.
class ReplayTeam
{
  public:
    explicit ReplayTeam(int ranks_per_group)
    {
        MPI_Init(nullptr, nullptr);
        team_ = std::make_unique<ensemble::MpiTeam>(MPI_COMM_WORLD);
        int const ranks = team_->size();
        if (ranks == ranks_per_group)
            return;
        team_.reset();
        if (ranks == 1) {
            fmt::print("note: {0} ranks simulated this run, and one does not get the same bits; mpirun -n "
                       "{0} does\n",
                       ranks_per_group);
            return;
        }
        MPI_Finalize();
        throw InputError(
            fmt::format("{} ranks simulated this run (run.ranks_per_group), and here are {}; start as "
                        "many, or one",
                        ranks_per_group, ranks));
    }
    ~ReplayTeam() { MPI_Finalize(); }
    ReplayTeam(ReplayTeam const&) = delete;
    ReplayTeam& operator=(ReplayTeam const&) = delete;

    dem::Team* get() const { return team_.get(); }
    bool is_first() const { return !team_ || team_->rank() == 0; }

  private:
    std::unique_ptr<ensemble::MpiTeam> team_;
};

//! Bit for bit, where any not-a-number equals any other.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

//! Tells the result beside the stored one. \return whether they are the same
bool compare(ensemble::Experiment const& experiment, ensemble::RunRecord const& stored,
             rig::RunResult const& result)
{
    bool const is_stored = stored.status != rig::RunStatus::not_run;
    bool all_same = stored.status == result.status;
    fmt::print("status: {}{}{}; stored: {}\n", name_of(result.status), result.reason.empty() ? "" : ": ",
               result.reason,
               is_stored ? name_of(stored.status) : "nothing, the campaign has not run it yet");
    for (std::size_t k = 0; k < experiment.responses.size(); ++k) {
        double const now = k < result.responses.size() ? result.responses[k] : std::nan("");
        double const before = k < stored.responses.size() ? stored.responses[k] : std::nan("");
        all_same = all_same && same(now, before);
        if (!is_stored) {
            fmt::print("{:<24} {}\n", experiment.responses[k].name, now);
            continue;
        }
        fmt::print("{:<24} {:<24} stored {:<24} {}\n", experiment.responses[k].name, now, before,
                   same(now, before) ? "the same bits" : "DIFFERENT");
    }
    return all_same;
}

int replay(ReplayOptions const& options)
{
    auto const campaign = ensemble::read_campaign_file(options.file);
    auto const stored = run_to_simulate(campaign, options.file, options.run);
    auto const& experiment = campaign.input.experiments.at(static_cast<std::size_t>(stored.experiment));
    if (options.check && stored.status == rig::RunStatus::not_run)
        throw InputError(
            fmt::format("{}: run {} has not been run yet, so that there is nothing to check; leave "
                        "--check out to simulate it",
                        options.file, options.run));

    std::optional<ReplayTeam> team;
    if (campaign.input.run.ranks_per_group > 1)
        team.emplace(campaign.input.run.ranks_per_group);
    bool const is_first = !team || team->is_first();
    rig::RunHooks hooks;
    hooks.team = team ? team->get() : nullptr;
    std::optional<observe::VtkFrames> frames;
    if (!options.frames.empty()) {
        if (is_first)
            frames.emplace(options.frames);
        hooks.frame_interval = options.frame_interval;
        hooks.on_frame = [&](auto const& snapshot) {
            if (frames)
                frames->write(snapshot);
        };
    }
    Checkpoints const checkpoints(campaign, stored);
    std::optional<rig::RunState> from;
    if (!options.from.empty()) {
        from = checkpoints.read(options.from);
        hooks.from = &*from;
    }
    if (!options.checkpoints.empty())
        hooks.on_stage = [&](rig::RunState const& state, std::string const& stage) {
            if (is_first)
                fmt::print("wrote {}\n", checkpoints.write(options.checkpoints, state, stage).string());
        };
    if ((hooks.from != nullptr || hooks.on_stage) && !experiment.rig->describe)
        throw InputError(fmt::format("{}: runs of the rig {} have no stages to be kept", options.file,
                                     experiment.rig->name));
    auto const result = simulate_again(campaign, stored, hooks);
    if (!is_first)
        return success;

    if (frames)
        fmt::print("wrote {}\n", frames->told());
    bool const all_same = compare(experiment, stored, result);
    return options.check && !all_same ? failure : success;
}

} // namespace

void add_replay(CLI::App& program, Action& action)
{
    auto options = std::make_shared<ReplayOptions>();
    auto* command = program.add_subcommand("replay", "simulate one run again, with frames for ParaView");
    command->add_option("FILE.h5", options->file, "campaign file")->required();
    command->add_option("--run", options->run, "number of the run, as in the report")->required();
    command->add_option("--frames", options->frames, "folder for VTK frames; none: no frames");
    command
        ->add_option("--frame-interval", options->frame_interval,
                     "simulated time between frames [s]; default 0.02")
        ->check(above_zero());
    command->add_option("--checkpoints", options->checkpoints,
                        "folder for what a replay can begin with, written where each stage begins");
    command->add_option("--from", options->from, "such a file of the same run, to begin there");
    command->add_flag("--check", options->check,
                      "exit with 1 unless the result equals the stored one bit for bit");
    command->callback([options, &action] { action = [options] { return replay(*options); }; });
}

} // namespace demens::cli
