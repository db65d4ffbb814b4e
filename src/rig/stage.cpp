#include "demens/rig/stage.hpp"

#include "demens/observe/wall_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace demens::rig {

StageRunner::StageRunner(dem::Simulation& simulation, RunHooks const& hooks, double check_interval)
    : simulation_(simulation), hooks_(hooks),
      steps_per_check_(
          std::max<std::int64_t>(1, std::llround(check_interval / simulation.options().time_step))),
      next_frame_(hooks.frame_interval > 0 ? 0.0 : std::numeric_limits<double>::infinity()),
      started_(std::chrono::steady_clock::now())
{
}

void StageRunner::run_until(std::string const& stage, double longest, std::function<bool()> const& done,
                            std::function<void()> const& observe)
{
    double const end = simulation_.time() + longest;
    while (true) {
        write_frames(stage);
        if (observe)
            observe();
        if (done())
            return;
        if (simulation_.time() >= end)
            throw RunFailure(
                RunStatus::timed_out,
                fmt::format("stage \"{}\" did not end within {:.3g} s of simulated time", stage, longest));
        simulation_.steps(steps_per_check_);
        check(stage);
    }
}

void StageRunner::run_for(std::string const& stage, double duration, std::function<void()> const& observe)
{
    double const end = simulation_.time() + duration;
    double const half_step = 0.5 * simulation_.options().time_step;
    run_until(
        stage, 2 * duration + 1, [&] { return simulation_.time() >= end - half_step; }, observe);
}

void StageRunner::check(std::string const& stage)
{
    std::string const when = fmt::format("in stage \"{}\" at {:.4f} s", stage, simulation_.time());
    switch (simulation_.check_health()) {
    case dem::Health::good:
        break;
    case dem::Health::not_a_number:
        throw RunFailure(RunStatus::not_a_number, "a position or force is not a number " + when);
    case dem::Health::escaped:
        throw RunFailure(RunStatus::escaped, "a particle left the domain " + when);
    case dem::Health::overlapping:
        throw RunFailure(RunStatus::overlapping,
                         fmt::format("two bodies overlap by more than {:.0f} % of the smaller radius {}",
                                     100 * simulation_.options().overlap_limit, when));
    case dem::Health::unbalanced:
        throw RunFailure(RunStatus::unbalanced,
                         fmt::format("the energy ledger misses {:.2g} % of the energy turned over, more than "
                                     "energy_closure_limit, {:.2g} %, {}; a smaller time step resolves the "
                                     "contacts better",
                                     100 * simulation_.energy().closure_error(),
                                     100 * simulation_.options().closure_limit, when));
    }
    if (is_agreed(hooks_.should_stop && hooks_.should_stop()))
        throw RunInterrupted();
    double const elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    if (is_agreed(hooks_.wall_time_limit > 0 && elapsed > hooks_.wall_time_limit))
        throw RunFailure(RunStatus::timed_out, fmt::format("the run took more than {:.0f} s of wall time {}",
                                                           hooks_.wall_time_limit, when));
}

bool StageRunner::is_agreed(bool here) const
{
    return hooks_.team ? hooks_.team->any(here) : here;
}

void StageRunner::write_frames(std::string const& stage)
{
    if (simulation_.time() < next_frame_ || !hooks_.on_frame)
        return;
    hooks_.on_frame(take_snapshot(simulation_, stage));
    next_frame_ = simulation_.time() + hooks_.frame_interval * (1 - 1e-9);
}

Snapshot take_snapshot(dem::Simulation const& simulation, std::string name)
{
    dem::Particles const& particles = simulation.particles();
    std::size_t const n = particles.size();
    Snapshot snapshot;
    snapshot.name = std::move(name);
    snapshot.time = simulation.time();
    for (auto* column : {&snapshot.x, &snapshot.y, &snapshot.z, &snapshot.radius, &snapshot.vx, &snapshot.vy,
                         &snapshot.vz, &snapshot.wx, &snapshot.wy, &snapshot.wz})
        column->resize(n);
    for (std::size_t k = 0; k < n; ++k) {
        std::uint32_t const id = particles.id[k];
        dem::Place const& p = particles.place[k];
        Vector3 const v = simulation.velocity(k), w = simulation.spin(k);
        snapshot.x[id] = p.x, snapshot.y[id] = p.y, snapshot.z[id] = p.z, snapshot.radius[id] = p.radius;
        snapshot.vx[id] = v.x, snapshot.vy[id] = v.y, snapshot.vz[id] = v.z;
        snapshot.wx[id] = w.x, snapshot.wy[id] = w.y, snapshot.wz[id] = w.z;
    }
    for (dem::Wall const& wall : simulation.walls())
        if (wall.active)
            observe::add_outline(snapshot, wall);
    return snapshot;
}

void record_end(dem::Simulation& simulation, RunResult& result)
{
    result.steps = simulation.steps_done();
    result.simulated_time = simulation.time();
    if (simulation.options().energy_ledger)
        result.energy = simulation.energy();
}

RunResult run_guarded(std::size_t responses, std::function<void(RunResult&)> const& body)
{
    RunResult result;
    result.responses.assign(responses, std::numeric_limits<double>::quiet_NaN());
    try {
        body(result);
        result.status = RunStatus::finished;
    } catch (RunInterrupted const&) {
        throw;
    } catch (RunFailure const& failure) {
        result.status = failure.status();
        result.reason = failure.what();
    } catch (std::exception const& failure) {
        result.status = RunStatus::error;
        result.reason = failure.what();
    }
    return result;
}

} // namespace demens::rig
