// Speed of the engine for CUDA devices: batches of a prepared state, beside the engine on one core.
#include "src/dem/cuda/batch.hpp"
#include "src/dem/params.hpp"
#include "tests/bench/replica.hpp"

#include <bit>
#include <chrono>
#include <cmath>
#include <numbers>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace demens;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

dem::SimulationOptions options_of(bench::State const& state, double skin)
{
    return {.time_step = state.time_step, .skin = skin > 0 ? skin : state.skin};
}

//! The state in a slot; `tiles` squared copies of it side by side.
void fill(dem::cuda::Batch& batch, std::uint32_t slot, bench::State const& state, double skin,
          std::string const& rolling)
{
    auto const simulation = bench::make_simulation(state, {bench::powder(rolling)});
    batch.begin(slot, dem::make_params(bench::powder(rolling), options_of(state, skin)));
    for (bench::Sphere const& s : state.spheres) {
        double const r = s.radius, mass = 2500 * 4.0 / 3.0 * std::numbers::pi * r * r * r;
        batch.add(slot, {s.position.x, s.position.y, s.position.z, r},
                  {s.velocity.x, s.velocity.y, s.velocity.z, mass, s.spin.x, s.spin.y, s.spin.z,
                   0.4 * mass * r * r},
                  {});
    }
    for (dem::Wall const& wall : simulation->walls())
        batch.change_walls(slot).add(wall);
}

//! Copies side by side along the axis of a drum, or in both directions of a box.
bench::State tiled(bench::State const& one, int along_x, int along_y)
{
    bench::State state = one;
    state.spheres.clear();
    double const offset = one.kind == "drum" ? 0.5 * (along_y - 1) * one.depth : 0;
    for (int i = 0; i < along_x; ++i)
        for (int j = 0; j < along_y; ++j)
            for (bench::Sphere sphere : one.spheres) {
                sphere.position += Vector3{i * one.width, j * one.depth - offset, 0};
                state.spheres.push_back(sphere);
            }
    state.depth = along_y * one.depth;
    if (one.kind == "box")
        state.width = along_x * one.width;
    return state;
}

struct Case
{
    std::uint32_t replicas = 1;
    int along_x = 1, along_y = 1;
    double skin = 0, seconds = 5;
    std::string rolling = "epsd2";
    bool on_host = false;
    std::int64_t digest = 0; //!< steps after which bits of the state are printed instead
};

//! Bits of a replica's places, motions and loads as one number.
std::uint64_t digest(dem::cuda::Batch const& batch, std::uint32_t slot)
{
    dem::Particles const p = batch.read(slot);
    std::uint64_t hash = 14695981039346656037u;
    auto const add = [&](double value) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        add(p.place[i].x), add(p.place[i].y), add(p.place[i].z);
        add(p.motion[i].vx), add(p.motion[i].vy), add(p.motion[i].vz);
        add(p.motion[i].wx), add(p.motion[i].wy), add(p.motion[i].wz);
        add(p.load[i].fx), add(p.load[i].fy), add(p.load[i].fz);
        add(p.load[i].tx), add(p.load[i].ty), add(p.load[i].tz);
    }
    for (auto const& load : batch.read_wall_loads(slot))
        add(load.force.x), add(load.force.y), add(load.force.z);
    return hash;
}

void run(bench::State const& one, Case const& c)
{
    bench::State const state = tiled(one, c.along_x, c.along_y);
    dem::cuda::Batch batch(c.on_host ? dem::cuda::make_host_device() : dem::cuda::make_cuda_device(),
                           c.replicas);
    for (std::uint32_t slot = 0; slot < c.replicas; ++slot)
        fill(batch, slot, state, c.skin, c.rolling);
    if (c.digest > 0) {
        batch.advance(std::vector<std::int64_t>(c.replicas, c.digest));
        fmt::print("{} x {}, {} steps, {} searches: {:016x}\n", c.replicas, state.spheres.size(), c.digest,
                   batch.rebuilds(0), digest(batch, c.replicas - 1));
        return;
    }
    std::vector<std::int64_t> steps(c.replicas, 200);
    batch.advance(steps); // histories, rooms, graphs
    std::uint32_t const rebuilds = batch.rebuilds(0);
    std::int64_t done = 0;
    steps.assign(c.replicas, c.on_host ? 10 : 64);
    auto const start = Clock::now();
    while (seconds_since(start) < c.seconds) {
        batch.advance(steps);
        done += steps[0];
    }
    double const seconds = seconds_since(start);
    double const particles = static_cast<double>(c.replicas) * static_cast<double>(state.spheres.size());
    bool healthy = true;
    for (std::uint32_t slot = 0; slot < c.replicas; ++slot)
        healthy = healthy && batch.status(slot) == dem::cuda::Status::running;
    double const made = batch.rebuilds(0) - rebuilds;
    fmt::print("| {} | {} x {} | {} | {:.3g} | {:.1f} | {:.1f} | {:.2f} |{}\n", one.kind, c.replicas,
               state.spheres.size(), c.rolling, particles * static_cast<double>(done) / seconds,
               1e6 * seconds / static_cast<double>(done), static_cast<double>(done) / std::max(made, 1.0),
               2.0 * static_cast<double>(batch.count_contacts(0).pairs) /
                   static_cast<double>(state.spheres.size()),
               healthy ? "" : " NOT HEALTHY |");
    std::fflush(stdout);
}

void run_cpu(bench::State const& state, Case const& c)
{
    auto const simulation =
        bench::make_simulation(state, {.model = bench::powder(c.rolling), .skin = c.skin});
    simulation->advance(200);
    std::int64_t done = 0;
    auto const start = Clock::now();
    while (seconds_since(start) < c.seconds) {
        simulation->advance(10);
        done += 10;
    }
    double const seconds = seconds_since(start);
    fmt::print("| {} | one core, 1 x {} | {} | {:.3g} | {:.1f} | | |\n", state.kind, state.spheres.size(),
               c.rolling,
               static_cast<double>(state.spheres.size() * static_cast<std::size_t>(done)) / seconds,
               1e6 * seconds / static_cast<double>(done));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Speed of the engine for CUDA devices");
    std::vector<std::string> folders;
    Case c;
    bool cpu = false;
    app.add_option("state", folders, "folders written by engine_speed prepare")->required();
    app.add_option("--replicas", c.replicas);
    app.add_option("--along-x", c.along_x);
    app.add_option("--along-y", c.along_y);
    app.add_option("--skin", c.skin, "[m]");
    app.add_option("--seconds", c.seconds);
    app.add_option("--rolling", c.rolling);
    app.add_flag("--on-host", c.on_host, "the same kernels as loops of this process");
    app.add_option("--digest", c.digest, "bits of the state after so many steps");
    app.add_flag("--cpu", cpu, "the engine on one core");
    CLI11_PARSE(app, argc, argv);
    try {
        for (std::filesystem::path const folder : folders) {
            bench::State const state = bench::read_state(folder / "state.txt");
            cpu ? run_cpu(tiled(state, c.along_x, c.along_y), c) : run(state, c);
        }
    } catch (std::exception const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
