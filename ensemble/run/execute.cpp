#include "ensemble/run/execute.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>

namespace demens::ensemble {

rig::RunInput run_input_of(CampaignInput const& input, RunRecord const& plan)
{
    return input.run_input(plan.factors, plan.point, plan.experiment, plan.replicate, plan.overrides());
}

namespace {

void fail(rig::RunResult& result, rig::RunStatus status, std::string reason)
{
    result.status = status;
    result.reason = std::move(reason);
}

//! A rig's promises, checked: what breaks them must not reach a fit.
void check_result(rig::RunResult& result, Experiment const& experiment)
{
    if (result.status == rig::RunStatus::finished) {
        if (result.responses.size() != experiment.responses.size())
            fail(result, rig::RunStatus::error,
                 fmt::format("rig \"{}\" gave {} responses instead of {}", experiment.rig->name,
                             result.responses.size(), experiment.responses.size()));
        for (std::size_t k = 0; k < result.responses.size() && result.status == rig::RunStatus::finished; ++k)
            if (!std::isfinite(result.responses[k]))
                fail(result, rig::RunStatus::not_a_number,
                     fmt::format("response {} is {}", experiment.responses[k].name, result.responses[k]));
    } else if (result.status == rig::RunStatus::not_run) {
        fail(result, rig::RunStatus::error, fmt::format("rig \"{}\" gave no status", experiment.rig->name));
    }
    result.responses.resize(experiment.responses.size(), std::numeric_limits<double>::quiet_NaN());
}

//! The other ranks of the group have memory, and wait for this one: only a death ends that. The journal knows
//! which run it was.
[[noreturn]] void die_alone(RunRecord const& plan)
{
    fmt::print(stderr,
               "run {}: not enough memory on a rank of its group; the program ends here, go on with it "
               "on more memory\n",
               plan.run);
    std::abort();
}

rig::RunResult simulate(CampaignInput const& input, RunRecord const& plan, rig::RunHooks const& hooks)
{
    auto const& experiment = input.experiments.at(static_cast<std::size_t>(plan.experiment));
    rig::RunResult result;
    try {
        result = experiment.rig->run(run_input_of(input, plan), hooks);
    } catch (rig::RunInterrupted const&) {
        throw;
    } catch (std::bad_alloc const&) {
        if (hooks.team)
            die_alone(plan);
        fail(result, rig::RunStatus::error, "not enough memory");
    } catch (std::exception const& error) {
        fail(result, rig::RunStatus::error, error.what());
    } catch (...) {
        fail(result, rig::RunStatus::error, "unknown exception");
    }
    return result;
}

double predicted_cost(CampaignInput const& input, RunRecord const& plan)
{
    try {
        auto const& rig = *input.experiments.at(static_cast<std::size_t>(plan.experiment)).rig;
        double const cost = rig.predict_cost(run_input_of(input, plan));
        return std::isfinite(cost) ? cost : 0;
    } catch (std::exception const&) {
        return 0; // the run will say what is wrong
    }
}

} // namespace

namespace {

//! \throws InputError
void check_plan(WavePlan const& plan, CampaignInput const& input)
{
    for (auto const& point : plan.points)
        if (point.size() != input.factors.size())
            throw InputError(fmt::format("a design point has {} values, but the campaign has {} factors",
                                         point.size(), input.factors.size()));
    if (plan.amplitudes.size() != (plan.effects.empty() ? 0 : plan.points.size()))
        throw InputError(fmt::format("{} design points with {} effects have {} rows of amplitudes",
                                     plan.points.size(), plan.effects.size(), plan.amplitudes.size()));
    for (auto const& row : plan.amplitudes)
        if (row.size() != plan.effects.size())
            throw InputError(fmt::format("a design point has {} amplitudes, but its wave {} effects",
                                         row.size(), plan.effects.size()));
    if (!std::is_sorted(plan.experiments.begin(), plan.experiments.end()))
        throw InputError("the experiments of a wave must stand in the order of the campaign");
    for (int const e : plan.experiments)
        if (e < 0 || e >= static_cast<int>(input.experiments.size()))
            throw InputError(fmt::format("there is no experiment {}", e));
}

std::vector<int> calibrating(CampaignInput const& input)
{
    std::vector<int> numbers;
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        if (input.experiments[e].role == ExperimentRole::calibrate)
            numbers.push_back(static_cast<int>(e));
    return numbers;
}

std::vector<double> curve_responses(Experiment const& experiment, rig::RunResult const& result)
{
    std::vector<double> all;
    for (auto const& curve : experiment.curves)
        for (double const response : responses_of(curve, result))
            all.push_back(response);
    return all;
}

std::vector<double> picture_responses(Experiment const& experiment, rig::RunResult const& result)
{
    return experiment.picture ? responses_of(*experiment.picture, result) : std::vector<double>{};
}

void add_comparisons(Experiment const& experiment, rig::RunResult& result)
{
    if (result.status != rig::RunStatus::finished)
        return;
    for (auto const& made : {curve_responses(experiment, result), picture_responses(experiment, result)})
        result.responses.insert(result.responses.end(), made.begin(), made.end());
}

} // namespace

rig::RunResult run_experiment(Experiment const& experiment, rig::RunInput const& input,
                              rig::RunHooks const& hooks)
{
    auto result = experiment.rig->run(input, hooks);
    add_comparisons(experiment, result);
    return result;
}

FinishedRun finished_run(CampaignInput const& input, RunRecord const& plan, rig::RunResult result,
                         double wall_time)
{
    auto const& experiment = input.experiments.at(static_cast<std::size_t>(plan.experiment));
    try {
        add_comparisons(experiment, result);
    } catch (std::exception const& error) {
        fail(result, rig::RunStatus::error, error.what());
    }
    check_result(result, experiment);
    FinishedRun run{plan,
                    {std::move(result.snapshots), std::move(result.series), std::move(result.profiles)}};
    run.record.status = result.status;
    run.record.reason = std::move(result.reason);
    run.record.responses = std::move(result.responses);
    run.record.wall_time = wall_time;
    run.record.simulated_time = result.simulated_time;
    run.record.steps = result.steps;
    run.record.particles = result.particles;
    run.record.energy = result.energy;
    return run;
}

FinishedRun execute(CampaignInput const& input, RunRecord const& plan, rig::RunHooks const& hooks)
{
    auto const begin = std::chrono::steady_clock::now();
    auto result = simulate(input, plan, hooks);
    return finished_run(input, plan, std::move(result),
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

Wave plan_runs(Campaign const& campaign, WavePlan const& plan)
{
    auto const& input = campaign.input;
    check_plan(plan, input);
    Wave wave;
    wave.number = static_cast<int>(campaign.waves.size());
    wave.purpose = plan.purpose;
    wave.replicates = plan.replicates;
    auto const effects =
        plan.effects.empty() ? nullptr : std::make_shared<std::vector<Effect> const>(plan.effects);
    auto const experiments = plan.experiments.empty() ? calibrating(input) : plan.experiments;
    int next_run = campaign.runs_planned(), next_point = campaign.points_planned();
    for (std::size_t p = 0; p < plan.points.size(); ++p, ++next_point)
        for (int const e : experiments) {
            int const replicates = plan.replicates > 0
                                       ? plan.replicates
                                       : input.experiments[static_cast<std::size_t>(e)].replicates;
            for (int replicate = 0; replicate < replicates; ++replicate) {
                RunRecord run;
                run.run = next_run++;
                run.wave = wave.number;
                run.point = next_point;
                run.experiment = e;
                run.replicate = replicate;
                run.seed = input.run_seed(run.point, run.experiment, replicate);
                run.factors = plan.points[p];
                run.effects = effects;
                if (effects)
                    run.amplitudes = plan.amplitudes[p];
                run.predicted_cost = predicted_cost(input, run);
                wave.runs.push_back(std::move(run));
            }
        }
    return wave;
}

} // namespace demens::ensemble
