// Times one simulation over the ranks of mpirun, on a state that `engine_speed prepare` wrote, and says where the
// time goes: `mpirun -n 2 team_speed FOLDER`. SCALING.md makes a model of it.
#include "ensemble/mpi/mpi_team.hpp"
#include "tests/bench/replica.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace demens;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin)
{
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

enum class Overlap
{
    on,
    off //!< the exchange ends before any force is computed
};

//! Passes everything on and measures how long it takes.
class TimedTeam : public dem::Team
{
  public:
    TimedTeam(dem::Team& team, Overlap overlap) : team_(team), overlap_(overlap) {}

    double reduced = 0, exchanged = 0; //!< every step: largest speed, ghosts [s]
    double numbers = 0, partners = 0;  //!< that this rank received in the last step

    int rank() const override { return team_.rank(); }
    int size() const override { return team_.size(); }
    void sum(std::span<double> values) override { team_.sum(values); }
    using dem::Team::largest;
    void largest(std::span<double> values) override
    {
        auto const begin = Clock::now();
        team_.largest(values);
        reduced += seconds_since(begin);
    }
    std::vector<Parcel> exchange(std::vector<Parcel> const& out) override { return team_.exchange(out); }
    std::vector<Bytes> gather(Bytes const& mine) override { return team_.gather(mine); }
    void begin(std::span<Link const> links, double const* out, double* in) override
    {
        auto const begin = Clock::now();
        numbers = partners = 0;
        for (Link const& link : links)
            numbers += static_cast<double>(link.in_count), partners += link.in_count > 0;
        team_.begin(links, out, in);
        if (overlap_ == Overlap::off)
            team_.finish();
        exchanged += seconds_since(begin);
    }
    void finish() override
    {
        auto const begin = Clock::now();
        if (overlap_ == Overlap::on)
            team_.finish();
        exchanged += seconds_since(begin);
    }

  private:
    dem::Team& team_;
    Overlap overlap_;
};

//! Seconds of a number of steps, by what they were spent on.
struct Times
{
    double all = 0, rebuilding = 0; //!< of them in steps that search neighbours anew
    double reduced = 0, exchanged = 0;
    std::int64_t steps = 0, rebuilds = 0; //!< steps of each kind
};

Times time_steps(dem::Simulation& simulation, TimedTeam& team, int steps)
{
    Times times;
    auto const begin = Clock::now();
    for (int k = 0; k < steps; ++k) {
        auto const rebuilds = simulation.rebuilds();
        team.reduced = team.exchanged = 0;
        auto const step_begin = Clock::now();
        simulation.step();
        if (simulation.rebuilds() > rebuilds) {
            times.rebuilding += seconds_since(step_begin);
            ++times.rebuilds;
        } else {
            times.reduced += team.reduced;
            times.exchanged += team.exchanged;
        }
    }
    times.all = seconds_since(begin);
    times.steps = steps;
    return times;
}

void report(Times const& times, dem::Simulation const& simulation, TimedTeam& team)
{
    double const plain = static_cast<double>(times.steps - times.rebuilds);
    std::array mean = {1e6 * times.all / static_cast<double>(times.steps),
                       1e6 * (times.all - times.rebuilding - times.reduced - times.exchanged) / plain,
                       1e6 * times.reduced / plain,
                       1e6 * times.exchanged / plain,
                       1e6 * times.rebuilding / static_cast<double>(std::max<std::int64_t>(times.rebuilds, 1)),
                       static_cast<double>(simulation.particles_here()),
                       static_cast<double>(simulation.ghosts_here()),
                       8 * team.numbers,
                       team.partners};
    auto most = mean;
    team.sum(mean);
    team.largest(std::span<double>(most));
    if (team.rank() > 0)
        return;
    char const* const names[] = {"step_us",        "compute_us", "reduce_us",      "exchange_us", "rebuild_step_us",
                                 "particles_here", "ghosts",     "bytes_received", "partners"};
    fmt::print("{{\"ranks\": {}, \"steps\": {}, \"rebuilds\": {}", team.size(), times.steps, times.rebuilds);
    for (std::size_t k = 0; k < mean.size(); ++k)
        fmt::print(", \"{}\": [{:.5g}, {:.5g}]", names[k], mean[k] / team.size(), most[k]);
    fmt::print("}}\n");
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    CLI::App program{"Speed of one simulation over several ranks; prints the mean and the largest over the ranks"};
    std::string folder, rolling = "none";
    int warm_up = 200, steps = 400, repeats = 3;
    bool alone = false, no_overlap = false;
    program.add_option("FOLDER", folder)->required();
    program.add_option("--rolling", rolling)->check(CLI::IsMember({"none", "epsd2"}));
    program.add_option("--warm-up", warm_up, "steps before the clock starts");
    program.add_option("--steps", steps);
    program.add_option("--repeats", repeats, "so many times; a line each");
    program.add_flag("--alone", alone, "every rank simulates all by itself, without a team");
    program.add_flag("--no-overlap", no_overlap, "wait for the ghosts before any force");
    int code = 0;
    try {
        program.parse(argc, argv);
        ensemble::MpiTeam ranks(MPI_COMM_WORLD);
        TimedTeam team(ranks, no_overlap ? Overlap::off : Overlap::on);
        auto const state = bench::read_state(std::filesystem::path(folder) / "state.txt");
        auto const simulation = bench::make_simulation(state, rolling, alone ? nullptr : &team);
        simulation->steps(warm_up);
        for (int k = 0; k < repeats; ++k)
            report(time_steps(*simulation, team, steps), *simulation, team);
    } catch (CLI::ParseError const& error) {
        code = program.exit(error);
    } catch (std::exception const& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    MPI_Finalize();
    return code;
}
