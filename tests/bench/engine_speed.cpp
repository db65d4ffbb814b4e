// Prepares the states of the speed comparison and times this engine on them; `peers.py` runs it beside the
// other codes.
#include "tests/bench/interleaved.hpp"
#include "tests/bench/law_block.hpp"
#include "tests/bench/replica.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>

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

std::map<std::string, bench::Sizes> const sizes_by_name = {{"spread", bench::Sizes::spread},
                                                           {"equal", bench::Sizes::equal},
                                                           {"one-to-ten", bench::Sizes::one_to_ten}};

void prepare(std::string const& kind, int spheres, std::string const& sizes,
             std::filesystem::path const& folder)
{
    std::filesystem::create_directories(folder);
    auto const make = kind == "box" ? bench::settled_box : bench::flowing_drum;
    bench::State const state = make(spheres, sizes_by_name.at(sizes));
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
    auto const simulation = bench::make_simulation(state, {bench::powder(rolling)});
    simulation->advance(warm_up);
    auto const rebuilds = simulation->counts().rebuilds;
    auto const start = std::chrono::steady_clock::now();
    double quickest = 1e9; // of groups of five steps: what the machine does when nothing disturbs it
    for (int done = 0; done < steps; done += 5) {
        auto const before = std::chrono::steady_clock::now();
        simulation->advance(std::min(5, steps - done));
        if (steps - done >= 5)
            quickest = std::min(
                quickest,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() / 5);
    }
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    double const n = static_cast<double>(state.spheres.size());
    fmt::print("{{\"seconds\": {}, \"quickest_step\": {}, \"coordination\": {}, \"rebuilds\": {}, "
               "\"peak_bytes\": {}}}\n",
               seconds, quickest, 2.0 * static_cast<double>(simulation->counts().contacts) / std::max(n, 1.0),
               simulation->counts().rebuilds - rebuilds, peak_memory());
}

//! How long the parts of a comparison take in turns.
struct Turns
{
    int warm_up = 200, steps = 200, rounds = 7;
};

void print_contestants(std::vector<bench::Contestant> const& contestants, std::string const& what)
{
    fmt::print(
        "| {} | million particle-steps/s | contacts | steps per rebuild | ns per contact | time per contact "
        "over the first |\n|---|---|---|---|---|---|\n",
        what);
    auto const& first = contestants.front();
    for (auto const& c : contestants)
        fmt::print("| {} | {:.2f} | {:.0f} | {:.0f} | {:.1f} | {:.2f} |\n", c.name,
                   c.million_particle_steps(), c.contacts, c.rebuilds > 0 ? 1 / c.rebuilds : 0.0,
                   c.nanoseconds_per_contact(), bench::total_ratio(c, first) * first.contacts / c.contacts);
}

//! The drum as a mesh against the drum as a cylinder.
void compare_mantles(std::filesystem::path const& folder, int triangles, Turns const& turns)
{
    bench::State const state = bench::read_state(folder / "state.txt");
    std::vector<bench::Contestant> contestants;
    for (int const n : {0, triangles}) {
        bench::Setting const setting{.model = bench::powder("none"), .mantle_triangles = n};
        contestants.push_back({n == 0 ? "cylinder" : fmt::format("mesh, {} triangles", n),
                               bench::make_simulation(state, setting)});
    }
    bench::time_in_turns(contestants, turns.warm_up, turns.steps, turns.rounds);
    print_contestants(contestants, "mantle");
    fmt::print("\ntime of a step, mesh over cylinder: total {:.3f}, best {:.3f}, median {:.3f}\n",
               bench::total_ratio(contestants[1], contestants[0]),
               contestants[1].best() / contestants[0].best(),
               bench::median_ratio(contestants[1], contestants[0]));
}

//! Several prepared states beside each other, e.g. of different sizes of spheres, each with several skins.
void compare_states(std::vector<std::string> const& folders, std::vector<double> const& skin_shares,
                    Turns const& turns)
{
    std::vector<bench::Contestant> contestants;
    for (std::filesystem::path const folder : folders) {
        bench::State const state = bench::read_state(folder / "state.txt");
        for (double const share : skin_shares)
            contestants.push_back(
                {skin_shares.size() > 1 ? fmt::format("{}, skin x {:g}", folder.filename().string(), share)
                                        : folder.filename().string(),
                 bench::make_simulation(state,
                                        {.model = bench::powder("none"), .skin = share * state.skin})});
    }
    bench::time_in_turns(contestants, turns.warm_up, turns.steps, turns.rounds);
    print_contestants(contestants, "state");
}

//! Every law, and some combinations, against what its arithmetic alone explains: the time of the plain
//! Hertz-Mindlin contact and what geometry and laws take more than there on a block in cache.
void compare_laws(std::filesystem::path const& folder, Turns const& turns)
{
    bench::State const state = bench::read_state(folder / "state.txt");
    std::vector<bench::LawChoice> choices = {{}};
    for (auto const& choice : bench::single_laws())
        if (choice[0].second != "none" && choice[0].second != "hertz" && choice[0].second != "mindlin")
            choices.push_back(choice);
    choices.push_back({{"tangential", "none"}});
    choices.push_back(
        {{"normal", "hysteretic_spring"}, {"tangential", "linear_coulomb"}, {"rolling", "constant_torque"}});
    choices.push_back({{"tangential", "mindlin_rescale"}, {"rolling", "epsd2"}});
    choices.push_back({{"tangential", "mindlin_rescale"}, {"rolling", "epsd2"}, {"cohesion", "jkr"}});
    choices.push_back(
        {{"tangential", "mindlin_deresiewicz"}, {"rolling", "epsd"}, {"cohesion", "capillary"}});
    std::vector<bench::Contestant> contestants;
    std::vector<double> arithmetic;
    for (auto const& choice : choices) {
        std::string name;
        for (auto const& [kind, law] : choice)
            name += (name.empty() ? "" : " + ") + (law == "none" ? "no " + kind : law);
        contact::Model const model = bench::powder_with(choice);
        contestants.push_back(
            {name.empty() ? "hertz + mindlin" : name, bench::make_simulation(state, {model})});
        arithmetic.push_back(bench::arithmetic_nanoseconds(model));
    }
    bench::time_in_turns(contestants, turns.warm_up, turns.steps, turns.rounds);
    fmt::print("| law | million particle-steps/s | contacts | steps per rebuild | ns per contact | "
               "arithmetic alone | explained | speed over explained |\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t k = 0; k < contestants.size(); ++k) {
        auto const& c = contestants[k];
        double const explained = contestants[0].nanoseconds_per_contact() + arithmetic[k] - arithmetic[0];
        fmt::print("| {} | {:.2f} | {:.0f} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |{}\n", c.name,
                   c.million_particle_steps(), c.contacts,
                   c.rebuilds > 0 ? fmt::format("{:.0f}", 1 / c.rebuilds) : "none",
                   c.nanoseconds_per_contact(), arithmetic[k], explained,
                   explained / c.nanoseconds_per_contact(),
                   c.simulation->health() == dem::Health::good ? "" : " not healthy");
    }
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App program{"Speed of the engine on the states that peers.py compares"};
    program.require_subcommand(1);
    std::string folder, from, kind = "box", sizes = "spread", rolling = "none";
    std::vector<std::string> folders;
    int spheres = 20000, warm_up = 1000, steps = 2000, triangles = 10000, along_x = 5, along_y = 5;
    std::vector<double> skin_shares = {1};
    Turns turns;
    auto const add_turns = [&](CLI::App& command) {
        command.add_option("--warm-up", turns.warm_up, "steps before the clock starts");
        command.add_option("--steps", turns.steps, "of each in a round");
        command.add_option("--rounds", turns.rounds);
    };
    auto* first = program.add_subcommand("prepare", "settle a state and write it for all codes");
    first->add_option("FOLDER", folder)->required();
    first->add_option("--kind", kind)->check(CLI::IsMember({"box", "drum"}));
    first->add_option("--sizes", sizes)->check(CLI::IsMember(sizes_by_name));
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
    auto* laws = program.add_subcommand("laws", "time every law on a prepared state; prints a table");
    laws->add_option("FOLDER", folder)->required();
    add_turns(*laws);
    auto* mantles = program.add_subcommand("mantle", "a prepared drum as a mesh and as a cylinder");
    mantles->add_option("FOLDER", folder)->required();
    mantles->add_option("--triangles", triangles);
    add_turns(*mantles);
    auto* states = program.add_subcommand("compare", "several prepared states beside each other");
    states->add_option("FOLDERS", folders)->required();
    states->add_option("--skin", skin_shares, "shares of the states' skins, beside each other")
        ->delimiter(',');
    add_turns(*states);
    CLI11_PARSE(program, argc, argv);
    try {
        if (first->parsed())
            prepare(kind, spheres, sizes, folder);
        else if (tiling->parsed())
            tile(from, along_x, along_y, folder);
        else if (second->parsed())
            time_steps(folder, rolling, warm_up, steps);
        else if (laws->parsed())
            compare_laws(folder, turns);
        else if (mantles->parsed())
            compare_mantles(folder, triangles, turns);
        else
            compare_states(folders, skin_shares, turns);
    } catch (std::exception const& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        return 1;
    }
}
