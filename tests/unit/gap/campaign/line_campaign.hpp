#pragma once

#include "ensemble/run/execute.hpp"
#include "ensemble/stored_arrays.hpp"

#include <string>
#include <vector>

namespace demens::test {

//! A rig whose responses are known in x (a factor), y (a factor), z (an effect's) and the seed's scatter:
//! first = 10 + 2 x + y + g z (3 + x) + z^2/2, second = 20 - 4 y + 5 g z, third = 30 + x with g = `gain`;
//! each with `scatter` times a number between -1 and 1.
inline ensemble::Rigs const& line_rigs()
{
    auto const number = [](std::string key, double value) {
        return OptionSpec{.key = std::move(key), .default_value = value, .doc = "a number"};
    };
    static ensemble::Rigs const rigs = {{
        .name = "line",
        .doc = "polynomials",
        .options = {number("x", 0.5), number("y", 0.5), number("z", 0), number("gain", 1), number("shift", 0),
                    number("scatter", 0)},
        .responses = {{"first", "1", "a response"},
                      {"second", "kg", "a response"},
                      {"third", "deg", "a response"}},
        .check = {},
        .predict_cost = [](rig::RunInput const&) { return 1e3; },
        .run =
            [](rig::RunInput const& input, rig::RunHooks const&) {
                auto const value = [&](char const* key) { return input.experiment.number(key); };
                double const x = value("x"), y = value("y"), z = value("z"), shift = value("shift");
                RandomStream random(input.seed);
                auto const noise = [&] { return value("scatter") * (2 * random.uniform() - 1); };
                rig::RunResult result;
                result.status = rig::RunStatus::finished;
                result.responses = {10 + 2 * x + y + value("gain") * z * (3 + x) + 0.5 * z * z + shift +
                                        noise(),
                                    20 - 4 * y + 5 * value("gain") * z + noise(), 30 + x + noise()};
                return result;
            },
    }};
    return rigs;
}

//! Two fitted experiments, one held out, one to be considered; what is measured belongs to x = 0.5, y = 0.5,
//! z.
inline std::string line_campaign(double z, double scatter = 0, std::string const& more = "")
{
    std::string text = "[campaign]\nname = \"line\"\n[material.glass]\ndensity = 2500\n";
    struct Condition
    {
        char const* name;
        double gain, shift;
    };
    for (auto const& [name, gain, shift] : {Condition{"one", 1, 0}, {"two", -0.5, 1}, {"held", -1.5, 2}}) {
        double const first = 11.5 + gain * z * 3.5 + 0.5 * z * z, second = 18 + 5 * gain * z;
        text += "[[experiment]]\nname = \"" + std::string(name) +
                "\"\nrig = \"line\"\nscatter = " + std::to_string(scatter) +
                "\ngain = " + std::to_string(gain) + "\nshift = " + std::to_string(shift) +
                "\ntarget.first = { value = " + std::to_string(first + shift) +
                ", scale = 0.1, sd = 0.05 }\ntarget.second = { value = " + std::to_string(second) +
                ", scale = 0.1, sd = 0.05 }\ntarget.third = { value = 30.5, scale = 0.1, sd = 0.05 }\n";
    }
    return text + R"(
[[experiment]]
name = "next"
rig = "line"
shift = 2.0
target.second = { scale = 0.1, sd = 0.05 }
[[factor]]
path = "experiment.x"
lower = 0.0
upper = 1.0
[[factor]]
path = "experiment.y"
lower = 0.0
upper = 1.0
[gap]
held_out = ["held"]
candidates = ["next"]
effects = ["z_added", "camera_angle"]
form_floor = 0.01
packings = 4
[[effect]]
name = "z_added"
typical = 0.4
set = [{ path = "experiment.z", per_unit = 1.0 }]
)" + more;
}

//! Adds a wave and runs it.
inline void run_wave(ensemble::Campaign& campaign, ensemble::WavePlan const& plan)
{
    auto wave = ensemble::plan_runs(campaign, plan);
    for (auto& run : wave.runs)
        run = ensemble::execute(campaign.input, run, {}).record;
    campaign.waves.push_back(std::move(wave));
}

//! A campaign that is calibrated at x = 0.5, y = 0.5.
inline ensemble::Campaign calibrated(std::string const& text)
{
    ensemble::Campaign campaign{ensemble::CampaignInput::from_text(text, "test", line_rigs()), {}, "done"};
    std::vector<std::vector<double>> points;
    for (double const x : {0.1, 0.4, 0.6, 0.9})
        for (double const y : {0.2, 0.5, 0.8})
            points.push_back({x, y});
    run_wave(campaign, {.points = points});
    campaign.waves.back().analysis = {{.path = ensemble::stored::optimum::estimate.path,
                                       .shape = {2},
                                       .data = {0.5, 0.5},
                                       .units = "1",
                                       .doc = ""}};
    return campaign;
}

} // namespace demens::test
