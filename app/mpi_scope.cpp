#include "app/mpi_scope.hpp"

#include "app/command.hpp"
#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <chrono>
#include <fmt/format.h>
#include <mpi.h>
#include <thread>

namespace demens::cli {
namespace {

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

} // namespace

int on_all_ranks(std::function<int()> const& act)
{
    MpiScope const mpi;
    int code = failure;
    std::string message;
    try {
        return act();
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

} // namespace demens::cli
