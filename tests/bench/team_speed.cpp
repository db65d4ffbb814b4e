// Times one simulation over the ranks of mpirun, on a state that `engine_speed prepare` wrote, and says where
// the time goes: `mpirun -n 2 team_speed FOLDER`. SCALING.md makes a model of it.
#include "ensemble/mpi/mpi_team.hpp"
#include "tests/bench/replica.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace demens;

//! A clock on the wall, and one that stands still while others have the core [s].
struct Moment
{
    double wall = 0, processor = 0;

    static Moment now() { return {seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_THREAD_CPUTIME_ID)}; }
    Moment& operator+=(Moment const& other)
    {
        wall += other.wall, processor += other.processor;
        return *this;
    }
    friend Moment operator-(Moment const& a, Moment const& b)
    {
        return {a.wall - b.wall, a.processor - b.processor};
    }

  private:
    static double seconds_of(clockid_t clock)
    {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
};

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

    Moment reduced, exchanged;        //!< every step: largest speed, ghosts
    double numbers = 0, partners = 0; //!< that this rank received in the last step

    int rank() const override { return team_.rank(); }
    int size() const override { return team_.size(); }
    void sum(std::span<double> values) override { team_.sum(values); }
    using dem::Team::largest;
    void largest(std::span<double> values) override
    {
        auto const begin = Moment::now();
        team_.largest(values);
        reduced += Moment::now() - begin;
    }
    std::vector<Parcel> exchange(std::vector<Parcel> const& out) override { return team_.exchange(out); }
    std::vector<Bytes> gather(Bytes const& mine) override { return team_.gather(mine); }
    void begin(std::span<Link const> links, double const* out, double* in) override
    {
        auto const begin = Moment::now();
        numbers = partners = 0;
        for (Link const& link : links)
            numbers += static_cast<double>(link.in_count), partners += link.in_count > 0;
        team_.begin(links, out, in);
        if (overlap_ == Overlap::off)
            team_.finish();
        exchanged += Moment::now() - begin;
    }
    void finish() override
    {
        auto const begin = Moment::now();
        if (overlap_ == Overlap::on)
            team_.finish();
        exchanged += Moment::now() - begin;
    }

  private:
    dem::Team& team_;
    Overlap overlap_;
};

//! Seconds of one step.
struct Step
{
    double all, computed, reduced, exchanged; //!< computed: on the processor, the others on the wall
};

//! Steps with and without a search for neighbours.
struct Times
{
    std::vector<Step> plain, rebuilding;
};

Times time_steps(dem::Simulation& simulation, TimedTeam& team, int steps)
{
    Times times;
    for (int k = 0; k < steps; ++k) {
        auto const rebuilds = simulation.counts().rebuilds;
        team.reduced = team.exchanged = {};
        auto const begin = Moment::now();
        simulation.advance(1);
        auto& kind = simulation.counts().rebuilds > rebuilds ? times.rebuilding : times.plain;
        auto const step = Moment::now() - begin;
        kind.push_back({step.wall, (step - team.reduced - team.exchanged).processor, team.reduced.wall,
                        team.exchanged.wall});
    }
    return times;
}

//! Means over the fastest part of the steps: others that use the machine slow down the rest.
Step mean_of_fastest(std::vector<Step> steps, double part)
{
    std::sort(steps.begin(), steps.end(), [](Step const& a, Step const& b) { return a.all < b.all; });
    steps.resize(std::min(steps.size(),
                          static_cast<std::size_t>(std::ceil(part * static_cast<double>(steps.size())))));
    Step mean{};
    for (Step const& step : steps) {
        double const weight = 1 / static_cast<double>(steps.size());
        mean.all += weight * step.all, mean.computed += weight * step.computed;
        mean.reduced += weight * step.reduced, mean.exchanged += weight * step.exchanged;
    }
    return mean;
}

void report(Times const& times, double part, dem::Simulation& simulation, TimedTeam& team)
{
    Step const plain = mean_of_fastest(times.plain, part),
               rebuilding = mean_of_fastest(times.rebuilding, part);
    std::array mean = {1e6 * plain.all,
                       1e6 * plain.computed,
                       1e6 * plain.reduced,
                       1e6 * plain.exchanged,
                       1e6 * rebuilding.all,
                       static_cast<double>(simulation.counts().particles_of_rank),
                       static_cast<double>(simulation.counts().ghosts_of_rank),
                       8 * team.numbers,
                       team.partners};
    auto most = mean;
    team.sum(mean);
    team.largest(std::span<double>(most));
    if (team.rank() > 0)
        return;
    char const* const names[] = {"step_us",     "compute_us",      "reduce_us",
                                 "exchange_us", "rebuild_step_us", "particles_here",
                                 "ghosts",      "bytes_received",  "partners"};
    fmt::print("{{\"ranks\": {}, \"steps\": {}, \"rebuilds\": {}", team.size(),
               times.plain.size() + times.rebuilding.size(), times.rebuilding.size());
    for (std::size_t k = 0; k < mean.size(); ++k)
        fmt::print(", \"{}\": [{:.5g}, {:.5g}]", names[k], mean[k] / team.size(), most[k]);
    fmt::print("}}\n");
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    CLI::App program{
        "Speed of one simulation over several ranks; prints the mean and the largest over the ranks"};
    std::string folder, rolling = "none";
    int warm_up = 200, steps = 400, repeats = 3;
    double part = 1;
    bool alone = false, no_overlap = false;
    program.add_option("FOLDER", folder)->required();
    program.add_option("--rolling", rolling)->check(CLI::IsMember({"none", "epsd2"}));
    program.add_option("--warm-up", warm_up, "steps before the clock starts");
    program.add_option("--steps", steps);
    program.add_option("--repeats", repeats, "so many times; a line each");
    program.add_option("--fastest", part, "means over this part of the steps, the fastest")
        ->check(CLI::Range(0.0, 1.0));
    program.add_flag("--alone", alone, "every rank simulates all by itself, without a team");
    program.add_flag("--no-overlap", no_overlap, "wait for the ghosts before any force");
    int code = 0;
    try {
        program.parse(argc, argv);
        ensemble::MpiTeam ranks(MPI_COMM_WORLD, ensemble::Overlap::always);
        TimedTeam team(ranks, no_overlap ? Overlap::off : Overlap::on);
        auto const state = bench::read_state(std::filesystem::path(folder) / "state.txt");
        auto const simulation =
            bench::make_simulation(state, {.model = bench::powder(rolling), .team = alone ? nullptr : &team});
        simulation->advance(warm_up);
        for (int k = 0; k < repeats; ++k)
            report(time_steps(*simulation, team, steps), part, *simulation, team);
    } catch (CLI::ParseError const& error) {
        code = program.exit(error);
    } catch (std::exception const& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    MPI_Finalize();
    return code;
}
