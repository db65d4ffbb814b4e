// How busy any number of groups would be: the scheduler's own decisions (expected_times, longest_first, who
// comes first takes the next run) under a simulated clock. Results and what they are based on: README.md
// here.
#include "demens/base/random.hpp"
#include "ensemble/run/schedule.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <numeric>
#include <queue>

using namespace demens;
using namespace demens::ensemble;

namespace {

//! What a campaign is like, and what its parts cost [s].
struct Model
{
    std::vector<double> mean_seconds = {16.4, 9.8, 4.5}; //!< of a run of each experiment
    double scatter = 0.2;                                //!< of a run over its prediction, lognormal
    int waves = 8;
    double answer = 0.05;      //!< from asking for a run to knowing it, rank 0 being busy with its own
    double service = 2e-6;     //!< rank 0's time for a question
    double store = 0.01;       //!< a shard and its journal lines
    double gather_run = 3e-4;  //!< a run, by one rank; all gather
    double gather_fixed = 0.2; //!< a gather, whatever it holds
    double plan = 1;           //!< surrogates and the choice of points
};

//! Runs of a wave: predicted costs, and how long they really take.
struct Runs
{
    Wave wave;
    std::vector<double> seconds;
};

double normal(RandomStream& random)
{
    return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

Runs make_runs(Model const& model, int count, RandomStream& random)
{
    Runs runs;
    for (int i = 0; i < count; ++i) {
        RunRecord run;
        run.run = i;
        run.experiment = i % static_cast<int>(model.mean_seconds.size());
        double const by_point =
            std::exp(0.2 * normal(random)); // particles and time step, which are predicted
        run.predicted_cost = 1e7 * model.mean_seconds[static_cast<std::size_t>(run.experiment)] * by_point;
        runs.wave.runs.push_back(run);
        runs.seconds.push_back(1e-7 * run.predicted_cost *
                               std::exp(model.scatter * normal(random) - model.scatter * model.scatter / 2));
    }
    return runs;
}

struct Outcome
{
    double span = 0; //!< [s] from the first run to the last gather
    double busy = 0; //!< [s] all groups together
    double idle = 0,
           alone = 0;   //!< [s] of all groups: waiting for the last run of a wave; for gather and plan
    double manager = 0; //!< [s] of rank 0, answering

    double efficiency(int groups) const { return busy / (span * groups); }
};

double after_wave(Model const& model, int runs, int groups)
{
    return model.gather_fixed + model.gather_run * std::ceil(static_cast<double>(runs) / groups) + model.plan;
}

//! Expected times as the scheduler has them once every experiment has been run.
std::vector<int> order_of(Runs const& runs, std::size_t experiments)
{
    Campaign campaign;
    campaign.input.experiments.resize(experiments);
    auto const expected = expected_times(campaign, runs.wave);
    std::vector<int> rows(runs.seconds.size());
    std::iota(rows.begin(), rows.end(), 0);
    return longest_first(std::move(rows), expected.seconds);
}

//! Groups by the time at which each is free, and the counter that they ask for the next run.
class Groups
{
  public:
    explicit Groups(int count)
        : free_(std::greater<>{}, std::vector<double>(static_cast<std::size_t>(count), 0.0))
    {
    }

    //! Runs a wave that is known from a time on. \return when its last run is over
    double run(Model const& model, Runs const& runs, double known, Outcome& outcome)
    {
        double end = known;
        for (int const row : order_of(runs, model.mean_seconds.size())) {
            double const asked = std::max(free_.top(), known);
            outcome.idle += asked - free_.top();
            free_.pop();
            counter_ = std::max(counter_, asked) + model.service;
            outcome.manager += model.service;
            double const seconds = runs.seconds[static_cast<std::size_t>(row)];
            double const done = counter_ + model.answer + seconds + model.store;
            outcome.busy += seconds;
            end = std::max(end, done);
            free_.push(done);
        }
        return end;
    }

    //! All wait for the last one, and then until the next wave begins.
    void wait(double end, double begin, Outcome& outcome)
    {
        auto const count = free_.size();
        for (; !free_.empty(); free_.pop())
            outcome.idle += end - free_.top();
        free_ = decltype(free_)(std::greater<>{}, std::vector<double>(count, begin));
    }

  private:
    std::priority_queue<double, std::vector<double>, std::greater<>> free_;
    double counter_ = 0; //!< when it can answer
};

//! Wave after wave, each gathered before the next is planned.
Outcome waves_in_turn(Model const& model, int groups, int runs_of_wave, RandomStream random)
{
    Outcome outcome;
    Groups all(groups);
    double begin = 0;
    for (int w = 0; w < model.waves; ++w) {
        double const end = all.run(model, make_runs(model, runs_of_wave, random), begin, outcome);
        double const alone = after_wave(model, runs_of_wave, groups);
        outcome.alone += alone * groups;
        begin = end + alone;
        all.wait(end, begin, outcome);
    }
    outcome.span = begin;
    return outcome;
}

//! What planning a wave ahead would give: wave n + 1 is planned from waves up to n - 1, gathered and planned
//! by rank 0 while the others go on, and begins where groups find nothing left of wave n.
Outcome waves_ahead(Model const& model, int groups, int runs_of_wave, RandomStream random)
{
    Outcome outcome;
    Groups all(groups);
    std::vector<double> known(static_cast<std::size_t>(model.waves) + 2,
                              0.0); // when the plan of a wave is there
    for (std::size_t w = 0; w < static_cast<std::size_t>(model.waves); ++w) {
        double const end = all.run(model, make_runs(model, runs_of_wave, random), known[w], outcome);
        known[w + 2] = end + after_wave(model, runs_of_wave, 1);
        outcome.span = std::max(outcome.span, known[w + 2]);
    }
    return outcome;
}

} // namespace

int main(int argc, char** argv)
{
    Model model;
    std::vector<int> groups = {2, 16, 256, 4096, 65536};
    std::vector<int> runs_per_group = {1, 2, 4, 8, 16};
    std::uint64_t seed = 1;
    CLI::App program{"How busy groups would be under this scheduler."};
    program.add_option("--groups", groups, "numbers of groups");
    program.add_option("--runs-per-group", runs_per_group, "runs of a wave, for each group");
    program.add_option("--mean-seconds", model.mean_seconds, "of a run of each experiment");
    program.add_option("--scatter", model.scatter, "of a run over its prediction");
    program.add_option("--waves", model.waves, "waves");
    program.add_option("--answer", model.answer, "[s] until a group that asks knows its run");
    program.add_option("--service", model.service, "[s] of rank 0 for an answer");
    program.add_option("--store", model.store, "[s] a shard");
    program.add_option("--gather-run", model.gather_run, "[s] a run");
    program.add_option("--gather-fixed", model.gather_fixed, "[s] a gather");
    program.add_option("--plan", model.plan, "[s] surrogates and choice of points");
    program.add_option("--seed", seed, "of the simulated times");
    CLI11_PARSE(program, argc, argv);
    fmt::print(
        "| groups | runs a wave | busy | idle at the ends of waves | gather and plan | rank 0 answering | "
        "busy, planned ahead |\n|---|---|---|---|---|---|---|\n");
    for (int const g : groups)
        for (int const per_group : runs_per_group) {
            RandomStream const random(seed);
            auto const now = waves_in_turn(model, g, g * per_group, random);
            auto const ahead = waves_ahead(model, g, g * per_group, random);
            double const all = now.span * g;
            fmt::print("| {} | {} | {:.1f} % | {:.1f} % | {:.1f} % | {:.2f} % | {:.1f} % |\n", g,
                       g * per_group, 100 * now.efficiency(g), 100 * now.idle / all, 100 * now.alone / all,
                       100 * now.manager / now.span, 100 * ahead.efficiency(g));
        }
    return 0;
}
