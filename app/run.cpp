#include "app/command.hpp"
#include "app/new_campaign.hpp"
#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "ensemble/session.hpp"
#include "tao_calib/calibrate.hpp"
#include "tao_calib/summary.hpp"

#include <chrono>
#include <fmt/format.h>
#include <mpi.h>
#include <thread>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;

//! MPI from construction to destruction.
class MpiScope
{
  public:
    MpiScope()
    {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_dup(MPI_COMM_WORLD, &failures_);
    }
    ~MpiScope()
    {
        MPI_Comm_free(&failures_);
        MPI_Finalize();
    }
    MpiScope(MpiScope const&) = delete;
    MpiScope& operator=(MpiScope const&) = delete;

    //! Whether all ranks fail as this one does; gives up waiting for the others after a while.
    bool all_fail() const
    {
        using namespace std::chrono_literals;
        auto const deadline = std::chrono::steady_clock::now() + 30s;
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Ibarrier(failures_, &request);
        int arrived = 0;
        while (!arrived && std::chrono::steady_clock::now() < deadline) {
            MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
            if (!arrived)
                std::this_thread::sleep_for(5ms);
        }
        return arrived;
    }

  private:
    MPI_Comm failures_; //!< apart from all other messages, which a failed rank leaves unfinished
};

//! One task of a job array; none: all runs of the campaign.
struct ArrayTask
{
    int task = 0, tasks = 0;
};

int calibrate(fs::path const& file)
{
    ensemble::Session session(MPI_COMM_WORLD, file);
    auto const end = tao_calib::calibrate(session);
    if (ensemble::rank_of(MPI_COMM_WORLD) == 0) {
        if (end == tao_calib::CalibrationEnd::drained)
            fmt::print("stopped as asked; nothing is lost, go on with the same command\n");
        else
            fmt::print("{}\n", tao_calib::summary(session.campaign()));
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
        return calibrate(campaign_file);
    auto const end = ensemble::run_shards(MPI_COMM_WORLD, campaign_file, array.task, array.tasks);
    return end == ensemble::WaveEnd::drained ? drained : success;
}

//! \return exit code, the same on all ranks; what went wrong is told once
int run_on_all_ranks(fs::path const& file, ArrayTask const& array)
{
    MpiScope const mpi;
    int code = failure;
    std::string message;
    try {
        return run_file(file, array);
    } catch (InputError const& error) {
        code = bad_input;
        message = error.what();
    } catch (std::exception const& error) {
        message = error.what();
    }
    int const rank = ensemble::rank_of(MPI_COMM_WORLD);
    bool const together = mpi.all_fail();
    if (rank == 0 || !together)
        fmt::print(stderr, "demens: error: {}\n", message);
    if (!together)
        MPI_Abort(MPI_COMM_WORLD, code); // other ranks wait for this one
    return code;
}

} // namespace

int run_campaign(std::string const& file)
{
    return run_on_all_ranks(file, {});
}

void add_run(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file;
        ArrayTask array;
    };
    auto options = std::make_shared<Options>();
    auto* command =
        program.add_subcommand("run", "run a campaign, or go on with it; under mpirun on all its ranks");
    command->add_option("FILE", options->file, "campaign file, or TOML file to make one of first")
        ->required();
    auto* task = command->add_option("--task", options->array.task, "of a job array: its number, from 0");
    auto* tasks = command->add_option("--tasks", options->array.tasks, "of a job array: how many there are")
                      ->check(CLI::PositiveNumber);
    task->needs(tasks);
    tasks->needs(task);
    command->callback([options, &action] {
        action = [options] { return run_on_all_ranks(options->file, options->array); };
    });
}

} // namespace demens::cli
