// One simulation of each experiment at the base values, without a campaign: what it would be, and what it
// measures.
#include "app/checks.hpp"
#include "app/command.hpp"
#include "demens/base/error.hpp"
#include "demens/base/extent.hpp"
#include "demens/base/text/number.hpp"
#include "demens/observe/vtk_frames.hpp"
#include "demens/picture_file/scene.hpp"
#include "demens/rig/programme/memory.hpp"
#include "demens/rig/programme/plausible.hpp"
#include "demens/rig/programme/programme.hpp"
#include "ensemble/run/execute.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::cli {
namespace {

using ensemble::CampaignInput;

struct TryOptions
{
    std::string file, experiment, frames, picture;
    std::vector<std::string> settings;
    double frame_interval = 0.02;
    bool plan_only = false;
    bool is_alone = true; //!< one experiment only
};

void set_values(CampaignInput& input, std::vector<std::string> const& settings)
{
    for (auto const& setting : settings) {
        auto const equals = setting.find('=');
        auto const value =
            equals == std::string::npos ? std::nullopt : text::number_of(setting.substr(equals + 1));
        if (!value)
            throw InputError(fmt::format(
                "--set {}: must be PATH=NUMBER, e.g. --set contact.A_B.static_friction=0.4", setting));
        input.set(setting.substr(0, equals), *value);
    }
}

//! Box around what stands there at first [m].
struct Box
{
    Extent x, y, z;

    void add(Vector3 const& centre, double radius)
    {
        x.include(centre.x, radius);
        y.include(centre.y, radius);
        z.include(centre.z, radius);
    }
    bool any() const { return x.lower <= x.upper; }
    std::string text() const
    {
        return !any()
                   ? "none"
                   : fmt::format("({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * x.lower,
                                 1e3 * y.lower, 1e3 * z.lower, 1e3 * x.upper, 1e3 * y.upper, 1e3 * z.upper);
    }
};

void print_plan(ensemble::Experiment const& experiment, rig::RunInput const& input)
{
    if (!experiment.rig->describe) {
        fmt::print("  expected to take {:.2g} s\n", experiment.rig->predict_cost(input) / 1e7);
        return;
    }
    constexpr double usual_rate = 1e7; // particle steps a second of one core, of a few thousand spheres
    auto const programme = experiment.rig->describe(input);
    auto const apparatus = programme.build();
    double const steps = programme.expected_duration / programme.time_step, cost = programme.expected_work();
    fmt::print("  particles        about {:.0f}\n", programme.expected_particles);
    fmt::print("  time step        {:.3g} s; about {:.3g} s simulated, {:.3g} steps\n", programme.time_step,
               programme.expected_duration, steps);
    fmt::print("  expected to take about {:.2g} s at 1e7 particle steps a second, one core of today\n",
               cost / usual_rate);
    fmt::print("  memory           at least {:.2g} MB\n",
               1e-6 * rig::memory_needed(programme.expected_particles));
    Box bodies;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    for (auto const& body : apparatus.bodies) {
        bodies.add(body.position, body.shape ? body.radius * body.shape->reach() : body.radius);
        smallest = std::min(smallest, 2 * body.radius);
        largest = std::max(largest, 2 * body.radius);
    }
    bool const are_spheres = std::all_of(apparatus.bodies.begin(), apparatus.bodies.end(),
                                         [](auto const& body) { return body.is_sphere(); });
    if (bodies.any())
        fmt::print("  at first         {} {} of {:.4g} to {:.4g} mm{}, from {}\n", apparatus.bodies.size(),
                   are_spheres ? "spheres" : "grains", 1e3 * smallest, 1e3 * largest,
                   are_spheres ? "" : " (spheres of the same volume)", bodies.text());
    for (std::size_t k = 0; k < apparatus.walls.size(); ++k) {
        auto const& wall = apparatus.walls[k];
        auto const& names = programme.names.walls;
        auto const name = k < names.size() ? names[k] : fmt::format("{}", k);
        if (auto const* round = std::get_if<dem::Cylinder>(&wall.shape);
            round && dem::side_of(*round) != dem::RoundSide::near)
            continue; // the same once more
        if (auto const* round = std::get_if<dem::Cone>(&wall.shape);
            round && dem::side_of(*round) != dem::RoundSide::near)
            continue;
        Vector3 const centre = 1e3 * dem::centre(wall.shape);
        fmt::print("  wall {:<11} of {}, around ({:.4g}, {:.4g}, {:.4g}) mm, reaches {:.4g} mm{}\n", name,
                   apparatus.model.materials[wall.material.value].name, centre.x, centre.y, centre.z,
                   1e3 * dem::extent(wall.shape), wall.active ? "" : "; not there at first");
    }
    for (auto const& warning : rig::unit_warnings(apparatus))
        fmt::print("  warning: {}\n", warning);
    if (experiment.rig->warnings)
        for (auto const& warning : experiment.rig->warnings(input))
            fmt::print("  warning: {}\n", warning);
}

//! A picture of how it ended, or of what was seen last before it failed. With several experiments each has
//! one of its own, by its name.
void write_picture(ensemble::Experiment const& experiment, rig::RunResult const& result,
                   TryOptions const& options)
{
    if (result.snapshots.empty()) {
        fmt::print("  no picture: this rig keeps none of its particles\n");
        return;
    }
    std::filesystem::path file = options.picture;
    if (!options.is_alone)
        file.replace_filename(
            fmt::format("{}.{}{}", file.stem().string(), experiment.name, file.extension().string()));
    picture_file::write_png(file, picture_file::picture_of(result.snapshots.back()));
    fmt::print("  wrote {}: {}, {:.4g} s\n", file.string(), result.snapshots.back().name,
               result.snapshots.back().time);
}

//! \return whether it finished
bool simulate(ensemble::Experiment const& experiment, rig::RunInput const& input, TryOptions const& options)
{
    rig::RunHooks hooks;
    std::optional<observe::VtkFrames> frames;
    if (!options.frames.empty()) {
        frames.emplace(options.frames);
        hooks.frame_interval = options.frame_interval;
        hooks.on_frame = [&](auto const& snapshot) { frames->write(snapshot); };
    }
    auto const begin = std::chrono::steady_clock::now();
    auto const result = ensemble::run_experiment(experiment, input, hooks);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    fmt::print("  {}{}{} after {:.3g} s simulated, {} steps of {} particles in {:.3g} s\n",
               rig::name_of(result.status), result.reason.empty() ? "" : ": ", result.reason,
               result.simulated_time, result.steps, result.particles, seconds);
    if (frames)
        fmt::print("  wrote {}\n", frames->told());
    if (!options.picture.empty())
        write_picture(experiment, result, options);
    for (std::size_t r = 0; r < experiment.responses.size() && r < result.responses.size(); ++r) {
        auto const target =
            std::find_if(experiment.targets.begin(), experiment.targets.end(),
                         [&](auto const& t) { return t.response_index == static_cast<int>(r); });
        bool const has_value = std::isfinite(result.responses[r]);
        fmt::print("  {:<28} {:<12} {:<8}{}\n", experiment.responses[r].name,
                   has_value ? fmt::format("{:.6g}", result.responses[r]) : "no value",
                   experiment.responses[r].units,
                   target == experiment.targets.end() || !has_value
                       ? ""
                       : fmt::format("measured {:.6g}, off by {:+.2g} scales", target->value,
                                     (result.responses[r] - target->value) / target->scale));
    }
    return result.status == rig::RunStatus::finished;
}

int try_out(TryOptions options)
{
    if (!options.picture.empty() && std::filesystem::path(options.picture).extension() != ".png")
        throw InputError(fmt::format("--picture {}: must be a .png", options.picture));
    auto input = CampaignInput::from_file(options.file);
    options.is_alone = input.experiments.size() == 1 || !options.experiment.empty();
    set_values(input, options.settings);
    bool all_finished = true, found = false;
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto const& experiment = input.experiments[e];
        if (!options.experiment.empty() && experiment.name != options.experiment)
            continue;
        found = true;
        fmt::print("{} ({}: {})\n", experiment.name, experiment.rig->name, experiment.rig->doc);
        auto const run = input.run_input({}, 0, static_cast<int>(e), 0);
        print_plan(experiment, run);
        std::fflush(stdout);
        if (!options.plan_only)
            all_finished &= simulate(experiment, run, options);
    }
    if (!found)
        throw InputError(fmt::format("--experiment {}: there is no such experiment in {}", options.experiment,
                                     options.file));
    return all_finished ? success : failure;
}

} // namespace

void add_try(CLI::App& program, Action& action)
{
    auto options = std::make_shared<TryOptions>();
    auto* command =
        program.add_subcommand("try", "simulate each experiment once at its base values, without a campaign");
    command->add_option("FILE.toml", options->file, "campaign as its author writes it")->required();
    command->add_option("--set", options->settings,
                        "PATH=NUMBER: another value than that of the file; as often as wanted");
    command->add_option("--experiment", options->experiment, "this one alone");
    command->add_flag("--plan", options->plan_only, "says what would be simulated, and simulates nothing");
    command->add_option("--frames", options->frames, "folder for VTK frames; none: no frames");
    command->add_option("--picture", options->picture,
                        "PNG file to write: particles and walls from the front, at the end");
    command
        ->add_option("--frame-interval", options->frame_interval,
                     "simulated time between frames [s]; default 0.02")
        ->check(above_zero());
    command->callback([options, &action] { action = [options] { return try_out(*options); }; });
}

} // namespace demens::cli
