// How many ranks a campaign keeps busy, for how long, and with how much memory.
#include "app/command.hpp"
#include "demens/base/words.hpp"
#include "demens/rig/programme/memory.hpp"
#include "demens/rig/programme/programme.hpp"
#include "ensemble/progress.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/schedule.hpp"
#include "ensemble/session.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace demens::cli {
namespace {

using ensemble::Campaign, ensemble::Wave, ensemble::duration_text;

double constexpr busy_enough = 0.85;       //!< of the ranks' time
double constexpr particles_a_rank = 10000; //!< from which on a further rank in a group pays
double constexpr program_memory = 6e7;     //!< [B] of a rank without particles

//! Of runs that are to be run, longest first.
struct Work
{
    std::vector<double> seconds;
    double total = 0;
    double particles = 0; //!< of the largest run
    int finished = 0;     //!< runs that the times rest on; 0: a guess
};

double particles_of(Campaign const& campaign, ensemble::RunRecord const& run)
{
    auto const& rig = *campaign.input.experiments[static_cast<std::size_t>(run.experiment)].rig;
    try {
        return rig.describe ? rig.describe(ensemble::run_input_of(campaign.input, run)).expected_particles
                            : 0;
    } catch (std::exception const&) {
        return 0; // the run will say what is wrong
    }
}

Work work_of(Campaign const& campaign, Wave const& wave)
{
    auto const expected = ensemble::expected_times(campaign, wave);
    Work work;
    work.finished = expected.finished;
    for (std::size_t row = 0; row < wave.runs.size(); ++row)
        if (wave.runs[row].status == rig::RunStatus::not_run) {
            work.seconds.push_back(expected.seconds[row]);
            work.particles = std::max(work.particles, particles_of(campaign, wave.runs[row]));
        }
    std::sort(work.seconds.rbegin(), work.seconds.rend());
    work.total = std::accumulate(work.seconds.begin(), work.seconds.end(), 0.0);
    return work;
}

double busy_share(Work const& work, int groups)
{
    return work.total / (groups * ensemble::time_to_run(work.seconds, groups));
}

//! As many groups as are mostly busy.
int advised_groups(Work const& work)
{
    int groups = static_cast<int>(work.seconds.size());
    while (groups > 1 && busy_share(work, groups) < busy_enough)
        --groups;
    return groups;
}

void print_table(Work const& work, int advised)
{
    fmt::print("  {:>6} {:>14} {:>6}\n", "groups", "takes", "busy");
    int const most = static_cast<int>(work.seconds.size());
    std::vector<int> rows{advised};
    for (int groups = 1; groups <= most; groups *= 2)
        rows.push_back(groups);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (int const groups : rows)
        fmt::print("  {:>6} {:>14} {:>4.0f} %{}\n", groups,
                   duration_text(ensemble::time_to_run(work.seconds, groups)), 100 * busy_share(work, groups),
                   groups == advised ? "   <- the most that are busy" : "");
}

//! A limit of Slurm that is long against one run: hours:minutes:00.
std::string time_limit(double longest)
{
    auto const minutes = static_cast<int>(std::ceil(std::max(30.0, 4 * longest / 60 + 10)));
    return fmt::format("{:02}:{:02}:00", minutes / 60, minutes % 60);
}

void print_all_runs(Campaign const& campaign, Work const& work, int groups)
{
    int const left = campaign.runs_left();
    double const mean = work.total / static_cast<double>(work.seconds.size());
    double const all = ensemble::time_to_run(work.seconds, groups) + left * mean / groups / busy_enough;
    fmt::print("  all {} runs that [stop] allows: some {} with {} group{}, if runs cost as much as these\n",
               campaign.runs_planned() + left, duration_text(all), groups, groups == 1 ? "" : "s");
}

int plan(std::string const& file)
{
    auto const campaign = ensemble::read_campaign_file(file);
    auto const* wave = campaign.open_wave();
    if (!wave) {
        fmt::print("{}: {}\n", file,
                   campaign.ended.empty() ? "no wave is planned; go on with: mpirun -n N demens " + file
                                          : "ended, " + campaign.ended);
        return success;
    }
    auto const work = work_of(campaign, *wave);
    int const groups = advised_groups(work), ranks_per_group = campaign.input.run.ranks_per_group;
    fmt::print("{}: wave {} ({}) has {} runs to be run, {} of one group in all, {} the longest\n",
               campaign.input.name, wave->number, word_for(wave->purpose), work.seconds.size(),
               duration_text(work.total), duration_text(work.seconds.front()));
    fmt::print("  {}\n",
               work.finished > 0
                   ? fmt::format("as {} finished runs took", work.finished)
                   : "a guess, no run has finished: 1e7 particle steps a second, one core of today");
    print_table(work, groups);
    print_all_runs(campaign, work, groups);
    if (!campaign.input.search.overlap && groups < static_cast<int>(work.seconds.size()))
        fmt::print(
            "  more groups than {} wait for the last runs of a wave; with [search] overlap = true they go on "
            "with the next one\n",
            groups);
    fmt::print("  memory: at least {:.0f} MB a rank, the largest run has about {:.0f} particles\n",
               1e-6 * (program_memory + rig::memory_needed(work.particles) / ranks_per_group),
               work.particles);
    if (ranks_per_group == 1 && work.particles >= 2 * particles_a_rank)
        fmt::print("  more ranks than {} pay in groups: [run] ranks_per_group up to {:.0f}, some 10,000 "
                   "particles each\n",
                   groups, work.particles / particles_a_rank);
    if (ranks_per_group > 1 && work.particles < particles_a_rank * ranks_per_group)
        fmt::print(
            "  [run] ranks_per_group = {} is much for {:.0f} particles: a rank should have some 10,000\n",
            ranks_per_group, work.particles);
    fmt::print("\n  mpirun -n {0} demens {1}\n  sbatch --ntasks={0} --time={2} slurm/demens.sbatch {1}\n",
               groups * ranks_per_group, file, time_limit(work.seconds.front()));
    return success;
}

} // namespace

void add_plan(CLI::App& program, Action& action)
{
    auto file = std::make_shared<std::string>();
    auto* command = program.add_subcommand(
        "plan", "how many ranks the wave to be run keeps busy, how long it takes, how much memory it needs");
    command->add_option("FILE.h5", *file, "campaign file")->required();
    command->callback([file, &action] { action = [file] { return plan(*file); }; });
}

} // namespace demens::cli
