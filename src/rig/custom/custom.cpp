#include "demens/rig/custom.hpp"

#include "demens/rig/stage.hpp"
#include "src/rig/custom/entry.hpp"
#include "src/rig/custom/specs.hpp"
#include "src/rig/custom/wall_driver.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig {
namespace {

using namespace custom;

//! One run: the world, its stages, and what is read off meanwhile.
class Run
{
  public:
    Run(Setup const& setup, RunHooks const& hooks, RunResult& result)
        : setup_(setup), result_(result),
          simulation_(setup.model, {.time_step = setup.time_step,
                                    .gravity = setup.gravity,
                                    .skin = setup.skin,
                                    .domain_lower = setup.domain.lower,
                                    .domain_upper = setup.domain.upper,
                                    .energy_ledger = setup.energy_ledger || setup.reads_energy(),
                                    .closure_limit = setup.closure_limit,
                                    .team = hooks.team}),
          world_{.simulation = simulation_,
                 .groups = std::vector<World::Ids>(setup.groups.size()),
                 .levels = std::vector<double>(setup.groups.size(), not_given)},
          walls_(world_, setup), runner_(simulation_, hooks, setup.interval)
    {
    }

    void stage(std::size_t number);
    void start_series(std::vector<ResponseInfo> const& infos, std::vector<OptionValues> const& tables);
    void finish()
    {
        record_end(simulation_, result_);
        result_.particles = static_cast<std::int64_t>(simulation_.particles().size());
    }

  private:
    void observe();
    bool is_over(Stage const& stage, double begun);
    void reduce_all(std::size_t stage, std::size_t first_sample);

    Setup const& setup_;
    RunResult& result_;
    dem::Simulation simulation_;
    World world_;
    WallDriver walls_;
    StageRunner runner_;
};

void Run::start_series(std::vector<ResponseInfo> const& infos, std::vector<OptionValues> const& tables)
{
    result_.series = {.names = {"time"}, .units = {"s"}, .columns = {{}}};
    for (std::size_t r = 0; r < infos.size(); ++r) {
        result_.series.names.push_back(infos[r].name);
        result_.series.units.push_back(quantity_units(tables[r]));
        result_.series.columns.emplace_back();
    }
}

void Run::observe()
{
    auto& columns = result_.series.columns;
    columns[0].push_back(simulation_.time());
    for (std::size_t r = 0; r < setup_.responses.size(); ++r)
        columns[r + 1].push_back(read_off(setup_.responses[r], world_));
}

bool Run::is_over(Stage const& stage, double begun)
{
    double const half_step = 0.5 * setup_.time_step, passed = simulation_.time() - begun;
    if (passed >= stage.shortest - half_step && stage.condition.holds(world_))
        return true;
    if (passed < stage.duration - half_step)
        return false;
    if (stage.condition.kind == "time" || stage.may_run_out)
        return true;
    throw RunFailure(
        RunStatus::timed_out,
        fmt::format("stage \"{}\" did not end within {:.3g} s of simulated time: its condition on {} "
                    "does not hold",
                    stage.name, stage.duration, stage.condition.kind));
}

void Run::stage(std::size_t number)
{
    auto const& stage = setup_.stages[number];
    walls_.begin(number);
    enter(world_, setup_, number);
    auto const first_sample = result_.series.columns[0].size();
    double const begun = simulation_.time();
    runner_.run_until(
        stage.name, 2 * stage.duration + 2 * setup_.interval, [&] { return is_over(stage, begun); },
        [&] { observe(); });
    result_.snapshots.push_back(take_snapshot(simulation_, stage.name));
    reduce_all(number, first_sample);
}

void Run::reduce_all(std::size_t stage, std::size_t first_sample)
{
    auto const since = [&](std::size_t column) {
        auto const& all = result_.series.columns[column];
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first_sample), all.end());
    };
    for (std::size_t r = 0; r < setup_.responses.size(); ++r)
        if (setup_.responses[r].stage == stage)
            result_.responses[r] = reduce(setup_.responses[r], since(0), since(r + 1));
}

void run(RunInput const& input, RunHooks const& hooks, RunResult& result)
{
    Setup const setup(input);
    Run run(setup, hooks, result);
    run.start_series(asked_responses(input.experiment), input.experiment.tables("response"));
    try {
        for (std::size_t k = 0; k < setup.stages.size(); ++k)
            run.stage(k);
        for (std::size_t r = 0; r < setup.responses.size(); ++r)
            if (std::isnan(result.responses[r]))
                throw RunFailure(RunStatus::error,
                                 fmt::format("the response {} has no value: {}", setup.responses[r].name,
                                             std::isnan(setup.responses[r].threshold)
                                                 ? "there was nothing to look at"
                                                 : "its threshold was not reached"));
    } catch (...) {
        run.finish();
        throw;
    }
    run.finish();
}

} // namespace

RigInfo custom_rig()
{
    return {.name = "custom",
            .doc = "made in the file itself: particles, walls and their motions, stages, responses",
            .options = experiment_options(),
            .tables = {particles_table(), region_table(), wall_table(), stage_table(), response_table()},
            .responses = {},
            .asked_responses = asked_responses,
            .check = [](RunInput const& input) { check_places(Setup(input)); },
            .warnings =
                [](RunInput const& input) {
                    Setup const setup(input);
                    auto all = warnings(read_walls(input));
                    for (auto const& group : setup.groups)
                        for (auto& warning : particle_warnings(group, setup.density(group)))
                            all.push_back(std::move(warning));
                    return all;
                },
            .predict_cost =
                [](RunInput const& input) {
                    Setup const setup(input);
                    return setup.expected_particles() * setup.longest_duration() / setup.time_step;
                },
            .run =
                [](RunInput const& input, RunHooks const& hooks) {
                    return run_guarded(input.experiment.tables("response").size(),
                                       [&](RunResult& result) { run(input, hooks, result); });
                }};
}

} // namespace demens::rig
