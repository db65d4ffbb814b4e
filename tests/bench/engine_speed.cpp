// Prepares the states of the speed comparison and times this engine on them; `peers.py` runs it beside the
// other codes.
#include "tests/bench/replica.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace demens;

//! Peak memory of this process [bytes].
double peak_memory()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            double kibibytes = 0;
            status >> kibibytes;
            return 1024 * kibibytes;
        }
    return 0;
}

void prepare(std::string const& kind, int spheres, std::filesystem::path const& folder)
{
    std::filesystem::create_directories(folder);
    bench::State const state = kind == "box" ? bench::settled_box(spheres) : bench::flowing_drum(spheres);
    bench::write_state(state, folder / "state.txt");
    bench::write_peer_data(state, folder / "state.data");
    if (kind == "drum")
        bench::write_drum_stl(state, 128, folder / "drum.stl");
}

void tile(std::filesystem::path const& from, int along_x, int along_y, std::filesystem::path const& folder)
{
    std::filesystem::create_directories(folder);
    bench::State const state = bench::tiled_box(bench::read_state(from / "state.txt"), along_x, along_y);
    bench::write_state(state, folder / "state.txt");
    bench::write_peer_data(state, folder / "state.data");
}

void time_steps(std::filesystem::path const& folder, std::string const& rolling, int warm_up, int steps)
{
    bench::State const state = bench::read_state(folder / "state.txt");
    auto const simulation = bench::make_simulation(state, rolling);
    simulation->steps(warm_up);
    auto const rebuilds = simulation->rebuilds();
    auto const start = std::chrono::steady_clock::now();
    double quickest = 1e9; // of groups of five steps: what the machine does when nothing disturbs it
    for (int done = 0; done < steps; done += 5) {
        auto const before = std::chrono::steady_clock::now();
        simulation->steps(std::min(5, steps - done));
        if (steps - done >= 5)
            quickest = std::min(
                quickest,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() / 5);
    }
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    double const n = static_cast<double>(state.spheres.size());
    fmt::print("{{\"seconds\": {}, \"quickest_step\": {}, \"coordination\": {}, \"rebuilds\": {}, "
               "\"peak_bytes\": {}}}\n",
               seconds, quickest,
               2.0 * static_cast<double>(simulation->particle_contacts()) / std::max(n, 1.0),
               simulation->rebuilds() - rebuilds, peak_memory());
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App program{"Speed of the engine on the states that peers.py compares"};
    program.require_subcommand(1);
    std::string folder, kind = "box", rolling = "none";
    int spheres = 20000, warm_up = 1000, steps = 2000, along_x = 5, along_y = 5;
    std::string from;
    auto* first = program.add_subcommand("prepare", "settle a state and write it for all codes");
    first->add_option("FOLDER", folder)->required();
    first->add_option("--kind", kind)->check(CLI::IsMember({"box", "drum"}));
    first->add_option("--spheres", spheres);
    auto* tiling = program.add_subcommand("tile", "a wide box from a prepared one, side by side with itself");
    tiling->add_option("FROM", from)->required();
    tiling->add_option("FOLDER", folder)->required();
    tiling->add_option("--along-x", along_x, "boxes side by side");
    tiling->add_option("--along-y", along_y);
    auto* second = program.add_subcommand("run", "time steps from a prepared state; prints JSON");
    second->add_option("FOLDER", folder)->required();
    second->add_option("--rolling", rolling)->check(CLI::IsMember({"none", "epsd2"}));
    second->add_option("--warm-up", warm_up, "steps before the clock starts");
    second->add_option("--steps", steps);
    CLI11_PARSE(program, argc, argv);
    try {
        if (first->parsed())
            prepare(kind, spheres, folder);
        else if (tiling->parsed())
            tile(from, along_x, along_y, folder);
        else
            time_steps(folder, rolling, warm_up, steps);
    } catch (std::exception const& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        return 1;
    }
}
