// A run from its beginning to its end, with frames, and looks at the clock and at the caller's wish to stop.
#include "demens/rig/programme/programme_run.hpp"

#include "demens/observe/snapshot_columns.hpp"
#include "demens/observe/wall_outline.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace demens::rig {
namespace {

constexpr double poll_interval = 0.1; //!< between looks at the clock [s]

//! Seconds of wall time.
double now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

//! So many steps, of which `steps` took so long [s], take about one poll interval.
std::int64_t next_portion(std::int64_t steps, double took)
{
    double const factor = std::clamp(poll_interval / std::max(took, 1e-9), 0.1, 2.0);
    return std::max<std::int64_t>(1, std::llround(static_cast<double>(steps) * factor));
}

//! Number of the grain of each element. \param ids of the elements, ascending: those of a grain follow that
//! of its first one
std::vector<std::int64_t> grain_numbers(dem::StateView const& grains, std::vector<std::uint32_t> const& ids)
{
    std::vector<std::uint32_t> firsts;
    for (std::size_t k = 0; k < grains.size(); ++k)
        firsts.push_back(grains.id(k).value);
    std::sort(firsts.begin(), firsts.end());
    std::vector<std::int64_t> numbers;
    std::size_t begun = 0;
    for (std::uint32_t const id : ids) {
        if (begun < firsts.size() && firsts[begun] == id)
            ++begun;
        numbers.push_back(static_cast<std::int64_t>(begun) - 1);
    }
    return numbers;
}

//! Number of the group of each particle, by its id; none where there are no groups.
std::vector<std::int64_t> groups_of(std::vector<std::uint32_t> const& ids,
                                    std::vector<EnteredGroup> const& groups)
{
    std::vector<std::int64_t> numbers(groups.empty() ? 0 : ids.size(), -1);
    for (std::size_t k = 0; k < numbers.size(); ++k)
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (groups[g].ids.contains(dem::ParticleId{ids[k]}))
                numbers[k] = static_cast<std::int64_t>(g);
    return numbers;
}

} // namespace

RunResult run_programme(Programme programme, RunHooks const& hooks)
{
    auto const names = programme.names;
    double const expected = programme.expected_duration;
    auto run = hooks.from != nullptr ? ProgrammeRun(std::move(programme), hooks.team, *hooks.from)
                                     : ProgrammeRun(std::move(programme), hooks.team);
    bool const has_frames = hooks.on_frame && hooks.frame_interval > 0;
    double next_frame = 0;
    if (has_frames || hooks.on_stage)
        run.watch([&](Bench& bench, std::string const& stage) {
            if (hooks.on_stage && bench.progress.stage > 0 && bench.progress.looks == 0)
                hooks.on_stage(run.save(), stage);
            if (!has_frames || bench.simulation.time() < next_frame)
                return;
            auto frame = take_snapshot(bench.simulation, stage);
            frame.names = names;
            frame.group = groups_of(frame.id, bench.progress.groups);
            hooks.on_frame(frame);
            next_frame = bench.simulation.time() + hooks.frame_interval * (1 - 1e-9);
        });
    // What depends on clocks and signals must end all ranks of a team or none, and after the same step.
    auto const agreed = [&](bool here) { return hooks.team ? hooks.team->any(here) : here; };
    double const started = now();
    for (std::int64_t portion = 1; !run.is_over();) {
        double const before = now();
        run.advance(portion);
        if (run.is_over())
            break;
        if (agreed(hooks.should_stop && hooks.should_stop()))
            throw RunInterrupted();
        if (hooks.on_progress)
            hooks.on_progress({expected > 0 ? run.time() / expected : 0, run.moment()});
        double const after = now();
        if (agreed(hooks.wall_time_limit > 0 && after - started > hooks.wall_time_limit))
            run.fail(RunStatus::timed_out,
                     fmt::format("the run took more than {:.0f} s of wall time (run.run_wall_time_s) {}",
                                 hooks.wall_time_limit, run.moment()));
        portion = next_portion(portion, hooks.team ? hooks.team->largest(after - before) : after - before);
    }
    return run.result();
}

namespace {

//! What each of the elements is of a hull; empty where there are none. \param ids of the elements, ascending
std::vector<std::uint32_t> parts_of_hulls(std::vector<dem::HullPlace> const& hulls,
                                          std::vector<std::uint32_t> const& ids)
{
    std::vector<std::uint32_t> parts(hulls.empty() ? 0 : ids.size(), Snapshot::no_hull);
    for (std::size_t h = 0; h < hulls.size(); ++h) {
        auto const first = static_cast<std::size_t>(
            std::lower_bound(ids.begin(), ids.end(), hulls[h].id.value) - ids.begin());
        grain::BodyShape const& shape = *hulls[h].shape;
        std::size_t const corners = shape.hull->core.vertices().size();
        for (std::size_t k = 0; k < shape.balls.size(); ++k) // its corners are the first of them
            parts[first + k] = k < corners ? static_cast<std::uint32_t>(h + 1) : Snapshot::within_a_hull;
    }
    return parts;
}

} // namespace

Snapshot take_snapshot(dem::Simulation& simulation, std::string name)
{
    auto const particles = simulation.read(dem::Fields::all);
    std::size_t const n = particles.size();
    Snapshot snapshot;
    snapshot.name = std::move(name);
    snapshot.time = simulation.time();
    for (auto* column : columns_of(snapshot))
        column->resize(n);
    for (auto* column : {&snapshot.fx, &snapshot.fy, &snapshot.fz, &snapshot.mass})
        column->resize(n);
    snapshot.material.resize(n), snapshot.id.resize(n);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return particles.id(a).value < particles.id(b).value; });
    for (std::size_t id = 0; id < n; ++id) { // of those that are there
        std::size_t const k = order[id];
        snapshot.id[id] = particles.id(k).value;
        dem::Place const& p = particles.place(k);
        Vector3 const v = particles.velocity(k), w = particles.spin(k);
        snapshot.x[id] = p.x, snapshot.y[id] = p.y, snapshot.z[id] = p.z, snapshot.radius[id] = p.radius;
        snapshot.vx[id] = v.x, snapshot.vy[id] = v.y, snapshot.vz[id] = v.z;
        Vector3 const f = particles.force(k);
        snapshot.fx[id] = f.x, snapshot.fy[id] = f.y, snapshot.fz[id] = f.z;
        snapshot.mass[id] = particles.mass(k), snapshot.material[id] = particles.material(k).value;
        snapshot.wx[id] = w.x, snapshot.wy[id] = w.y, snapshot.wz[id] = w.z;
    }
    if (simulation.counts().particles < n)
        snapshot.grain = grain_numbers(simulation.read_grains(dem::Fields::places), snapshot.id);
    snapshot.hull = parts_of_hulls(simulation.read_hulls(), snapshot.id);
    auto const& walls = simulation.walls();
    for (std::size_t number = 0; number < walls.size(); ++number) {
        if (!walls[number].active)
            continue;
        observe::add_outline(snapshot, walls[number]);
        snapshot.wall_of_box.resize(snapshot.walls.size(), static_cast<std::int64_t>(number));
        snapshot.wall_of_triangle.resize(snapshot.wall_triangles.size(), static_cast<std::int64_t>(number));
    }
    return snapshot;
}

} // namespace demens::rig
