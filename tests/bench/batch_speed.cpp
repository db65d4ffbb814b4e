// Speed of whole runs of a rig together on a device: drums from the filling to the last picture, looks
// included.
#include "demens/rig/programme/run_batch.hpp"

#include <chrono>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace demens;
using Clock = std::chrono::steady_clock;

struct Case
{
    int runs = 64, together = 0, threads = rig::usable_cores();
    double diameter_mm = 1.5;
    bool on_host = false;
};

//! A drum of 60 mm by 20 mm, a third full, that turns for half a second; half of it is looked at every 5 ms.
rig::RunInput drum(Case const& c, std::uint64_t seed)
{
    rig::RunInput input;
    input.model.materials = {{"grain", 2500, 5e6, 0.3}};
    contact::PairProperties pair{.first = "grain", .second = "grain"};
    pair.restitution = 0.5;
    pair.static_friction = pair.kinetic_friction = 0.3 + 0.01 * static_cast<double>(seed % 16);
    pair.rolling_friction = 0.1;
    pair.rolling = contact::RollingLaw::epsd2;
    input.model.pairs = {pair};
    double const largest = 1.1e-3 * c.diameter_mm;
    input.size_distributions.emplace("sieved", shape::SizeDistribution({0.8 * largest, largest}, {0, 1}));
    auto& options = input.experiment;
    options = defaults_of(rig::find_rig("drum")->options);
    for (auto const* key : {"material", "wall_material"})
        options.set(key, std::string("grain"));
    options.set("size_distribution", std::string("sieved"));
    options.set("radius_mm", 30.0);
    options.set("width_mm", 20.0);
    options.set("ends", std::string("turning"));
    options.set("speed_rpm", 15.0);
    options.set("fill_fraction", 0.33);
    options.set("solid_fraction", 0.58);
    options.set("discard_turns", 0.0625);
    options.set("measure_turns", 0.0625);
    options.set("samples_per_turn", std::int64_t{800});
    input.seed = seed;
    input.engine = c.on_host ? rig::EngineChoice::cuda_on_host : rig::EngineChoice::cuda;
    return input;
}

void run(Case const& c)
{
    auto const& info = *rig::find_rig("drum");
    auto const kind = c.on_host ? dem::EngineKind::cuda_on_host : dem::EngineKind::cuda;
    int const together = c.together > 0 ? c.together : c.runs;
    dem::DeviceBatch device(kind, 0, static_cast<std::uint32_t>(together));
    rig::RunBatch batch(device, c.threads, 0);
    auto const start = Clock::now();
    double particle_steps = 0, particles = 0;
    for (int next = 0, ended = 0; ended < c.runs;) {
        for (; next < c.runs && batch.has_room(); ++next)
            batch.begin(next, rig::programme_of(info, drum(c, static_cast<std::uint64_t>(next)), 1));
        for (auto const& one : batch.advance()) {
            if (one.result.status != rig::RunStatus::finished)
                fmt::print("run {}: {}\n", one.key, one.result.reason);
            particle_steps +=
                static_cast<double>(one.result.particles) * static_cast<double>(one.result.steps);
            particles += static_cast<double>(one.result.particles);
            ++ended;
        }
    }
    double const seconds = std::chrono::duration<double>(Clock::now() - start).count();
    fmt::print("| {} drums of {:.0f}, {} together | {:.1f} s | {:.3g} particle-steps/s | {:.0f} % in looks "
               "on {} threads |\n",
               c.runs, particles / c.runs, together, seconds, particle_steps / seconds,
               100 * batch.seconds_of_looks() / seconds, c.threads);
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Speed of whole runs of a rig together on a device");
    Case c;
    app.add_option("--runs", c.runs);
    app.add_option("--together", c.together, "default: all");
    app.add_option("--threads", c.threads, "that look at runs");
    app.add_option("--diameter", c.diameter_mm, "[mm]");
    app.add_flag("--on-host", c.on_host, "the same kernels as loops of this process");
    CLI11_PARSE(app, argc, argv);
    try {
        run(c);
    } catch (std::exception const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
