#pragma once

#include "demens/base/random.hpp"
#include "demens/rig/rig.hpp"
#include "ensemble/session.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <new>
#include <stdexcept>
#include <thread>

namespace demens::test {

//! Responses that any difference of an input bit changes: steps of the logistic map.
inline std::vector<double> formula(rig::RunInput const& input)
{
    double value = 0.1 + 0.8 * RandomStream(input.seed).uniform();
    for (int i = 0; i < 40; ++i)
        value = 3.7 * value * (1 - value) * (1 - 1e-3 * input.experiment.number("x")) +
                1e-6 * input.experiment.number("y");
    return {value, 2 * input.experiment.number("x") + input.experiment.number("y")};
}

inline rig::RunResult run_formula(rig::RunInput const& input, rig::RunHooks const& hooks)
{
    auto const& options = input.experiment;
    double const x = options.number("x");
    if (x > options.number("crash_above"))
        std::raise(static_cast<int>(options.integer("crash_signal")));
    auto const end =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(options.integer("milliseconds"));
    while (std::chrono::steady_clock::now() < end) {
        if (hooks.should_stop && hooks.should_stop())
            throw rig::RunInterrupted();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (x > options.number("memory_above"))
        throw std::bad_alloc();
    if (x > options.number("throw_above"))
        throw std::runtime_error("no sphere fits");

    rig::RunResult result;
    if (x > options.number("escape_above")) {
        result.status = rig::RunStatus::escaped;
        result.reason = "3 spheres have left";
        return result;
    }
    if (x > options.number("hang_above")) { // a rig ends at its limit
        auto const begin = std::chrono::steady_clock::now();
        while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() <
               hooks.wall_time_limit)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        result.status = rig::RunStatus::timed_out;
        result.reason = "not done at its limit";
        return result;
    }
    result.status = rig::RunStatus::finished;
    result.responses = formula(input);
    if (x > options.number("nan_above"))
        result.responses[0] = std::numeric_limits<double>::quiet_NaN();
    result.simulated_time = 2.5;
    result.steps = 1000;
    result.particles = static_cast<std::int64_t>(1 + input.seed % 5);
    if (x > 0.5)
        result.energy = dem::EnergyLedger{.potential = x, .lost_to_friction = 0.5, .turned_over = 2};
    result.series = {{"time_s", "value"}, {"s", "1"}, {{0.0, 0.5, 1.0}, {x, result.responses[1], 7.0}}};
    if (x > 0.25) // a run need not have every profile, nor as many points as another
        result.profiles = {{"surface", "height over x", {{"x", "height"}, {"m", "mm"}, {}}}};
    for (auto& profile : result.profiles) {
        auto const points = static_cast<std::size_t>(result.particles);
        profile.curve.columns = {std::vector(points, 0.5), std::vector(points, x)};
    }
    for (auto const* name : {"settled", "final"}) {
        rig::Snapshot snapshot;
        snapshot.name = name;
        snapshot.time = 1.5;
        for (std::int64_t p = 0; p < result.particles; ++p) {
            snapshot.x.push_back(static_cast<double>(p));
            snapshot.y.push_back(0.25);
            snapshot.z.push_back(x > 0.5 ? 0.5 : 0.125);
            snapshot.radius.push_back(0.0625);
        }
        if (x > 0.5) // some have polyhedra
            for (std::int64_t p = 0; p < result.particles; ++p)
                snapshot.hull.push_back(p == 0 ? rig::Snapshot::within_a_hull
                                               : static_cast<std::uint32_t>(p - 1));
        snapshot.walls = {{0, 0, 0, 1, 1, 1}};
        snapshot.wall_lines.assign(static_cast<std::size_t>(result.particles),
                                   {0, 0.5, 1, x > 0.5 ? 2.0 : 3.0, 4, 5});
        result.snapshots.push_back(std::move(snapshot));
    }
    return result;
}

//! A rig without particles to simulate, with switches for everything that can go wrong in one.
inline ensemble::Rigs const& formula_rigs()
{
    auto const number = [](std::string key, double value) {
        return OptionSpec{.key = std::move(key), .default_value = value, .doc = "a number"};
    };
    static ensemble::Rigs const rigs = {{
        .name = "formula",
        .doc = "a formula that takes its time",
        .options = {number("x", 0.5),
                    number("y", 0.5),
                    number("crash_above", 1e9),
                    number("memory_above", 1e9),
                    number("throw_above", 1e9),
                    number("escape_above", 1e9),
                    number("hang_above", 1e9),
                    number("nan_above", 1e9),
                    {.key = "crash_signal", .default_value = std::int64_t{SIGKILL}, .doc = "how it dies"},
                    {.key = "milliseconds", .default_value = std::int64_t{0}, .doc = "how long it takes"}},
        .responses = {{"map_value", "1", "end of the logistic map"}, {"length_m", "m", "2x + y"}},
        .check = [](rig::RunInput const&) {},
        .predict_cost = [](rig::RunInput const& input) { return 1e6 * (1 + input.experiment.number("x")); },
        .run = run_formula,
    }};
    return rigs;
}

//! A campaign of two experiments and two factors; `options` go into the first experiment's table.
inline std::string formula_campaign(std::string const& options = "", std::string const& sections = "")
{
    return R"([campaign]
name = "formula"
seed = 11

[material.glass]
density = 2500

[[experiment]]
name = "slow"
rig = "formula"
replicates = 2
)" + options +
           R"(
target.length_m = { value = 1.5, scale = 0.1, tolerance = 0.05 }

[[experiment]]
name = "fast"
rig = "formula"
target.map_value = { value = 0.5, scale = 0.2, sd = 0.1 }

[[factor]]
path = "experiment.x"
lower = 0.0
upper = 1.0

[[factor]]
path = "experiment.y"
lower = 0.0
upper = 1.0
)" + sections;
}

} // namespace demens::test
