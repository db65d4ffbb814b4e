#include "app/checks.hpp"
#include "app/command.hpp"
#include "app/log.hpp"
#include "app/mpi_scope.hpp"
#include "app/new_campaign.hpp"
#include "demens/base/words.hpp"
#include "ensemble/fit_quality.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/session.hpp"
#include "gap/campaign/diagnose.hpp"
#include "gap/campaign/report.hpp"
#include "tao_calib/calibrate.hpp"
#include "tao_calib/summary.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <mpi.h>
#include <spdlog/spdlog.h>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;

//! One task of a job array; none: all runs of the campaign.
struct ArrayTask
{
    int task = 0, tasks = 0;
    bool gathers = false; //!< takes in what the tasks have left, and plans the next wave
};

std::string left_text(ensemble::Campaign const& campaign)
{
    auto const* open = campaign.open_wave();
    return open ? fmt::format("wave {} ({}) is planned: its runs are for the tasks of a job array",
                              open->number, word_for(open->purpose))
                : "";
}

//! Why runs of the last wave failed, one line a reason, and how far off the best run is by now.
void print_wave(ensemble::Campaign const& campaign)
{
    auto const& wave = campaign.waves.back();
    std::map<std::string, std::vector<int>> failures; // runs by what became of them
    for (auto const& run : wave.runs)
        if (rig::has_failed(run.status))
            failures[rig::name_of(run.status)].push_back(run.run);
    for (auto const& [status, runs] : failures) {
        auto const first =
            std::find_if(wave.runs.begin(), wave.runs.end(),
                         [number = runs.front()](auto const& run) { return run.run == number; });
        spdlog::warn("  {} failed, {}; run {}: {}", runs.size(), status, first->run, first->reason);
    }
    if (auto const* responses = wave.find(ensemble::stored::optimum::best_responses))
        spdlog::info("  best run so far {}",
                     headline(ensemble::fit_quality(campaign.input, responses->data)));
}

//! With more groups they wait for rank 0, which gathers alone while waves overlap (tests/bench/scheduler).
int constexpr most_groups_to_overlap = 1000;

void warn_of_overlap(ensemble::Session const& session)
{
    if (session.campaign().input.search.overlap && session.groups() > most_groups_to_overlap)
        spdlog::warn(
            "{} groups and waves that overlap: all may wait for the one rank that gathers meanwhile; "
            "so many are busier with eight runs a group in a wave and [search] overlap = false",
            session.groups());
}

int calibrate(fs::path const& file, bool simulates)
{
    ensemble::Session session(MPI_COMM_WORLD, file, {.simulates = simulates});
    bool const is_root = ensemble::rank_of(MPI_COMM_WORLD) == 0;
    if (is_root) {
        if (auto const text = other_input_text(file, session.campaign().input); !text.empty())
            spdlog::warn("{}", text);
        warn_of_overlap(session);
    }
    auto const end = tao_calib::calibrate(session, MPI_COMM_WORLD, print_wave);
    if (is_root && end != tao_calib::CalibrationEnd::drained)
        fmt::print("{}\n", tao_calib::summary(session.campaign()));
    bool stopped = end == tao_calib::CalibrationEnd::drained;
    if (end == tao_calib::CalibrationEnd::finished && session.campaign().input.gap) {
        stopped = gap::diagnose(session) == ensemble::WaveEnd::drained;
        if (is_root && !stopped)
            fmt::print("{}", gap::gap_text(session.campaign()));
    }
    if (stopped) {
        if (is_root)
            fmt::print("{}\n", simulates ? "stopped as asked; nothing is lost, go on with the same command"
                                         : left_text(session.campaign()));
        return drained;
    }
    switch (end) {
    case tao_calib::CalibrationEnd::finished:
        return success;
    case tao_calib::CalibrationEnd::drained:
        return drained;
    case tao_calib::CalibrationEnd::failed:
        break;
    }
    return failure;
}

int run_file(fs::path const& file, ArrayTask const& array)
{
    auto campaign_file = file;
    if (file.extension() == ".toml") {
        campaign_file = default_campaign_file(file);
        ensemble::on_root(MPI_COMM_WORLD, [&] { make_or_accept(file, campaign_file); });
    }
    if (array.tasks == 0)
        return calibrate(campaign_file, !array.gathers);
    auto const end = ensemble::run_shards(MPI_COMM_WORLD, campaign_file, array.task, array.tasks);
    return end == ensemble::WaveEnd::drained ? drained : success;
}

int run_logging(std::string const& level, fs::path const& file, ArrayTask const& array)
{
    begin_log(level, ensemble::rank_of(MPI_COMM_WORLD));
    return run_file(file, array);
}

} // namespace

int run_campaign(std::string const& file, std::string const& log_level)
{
    return on_all_ranks([&] { return run_logging(log_level, file, {}); });
}

void add_run(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file, log_level = usual_log_level;
        ArrayTask array;
    };
    auto options = std::make_shared<Options>();
    auto* command =
        program.add_subcommand("run", "run a campaign, or go on with it; under mpirun on all its ranks");
    command->add_option("FILE", options->file, "campaign file, or TOML file to make one of first")
        ->required();
    auto* task = command->add_option("--task", options->array.task, "of a job array: its number, from 0");
    auto* tasks = command->add_option("--tasks", options->array.tasks, "of a job array: how many there are")
                      ->check(above_zero());
    task->needs(tasks);
    tasks->needs(task);
    command
        ->add_flag(
            "--gather", options->array.gathers,
            "between job arrays: take in what their tasks have left, plan the next wave, simulate nothing; "
            "exit code 75: there are runs for tasks")
        ->excludes(task);
    add_log_level(*command, options->log_level);
    command->callback([options, &action] {
        action = [options] {
            return on_all_ranks(
                [&] { return run_logging(options->log_level, options->file, options->array); });
        };
    });
}

} // namespace demens::cli
