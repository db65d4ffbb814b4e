#include "ensemble/mpi/shared_counters.hpp"

#include "ensemble/mpi/agreement.hpp"

#include <algorithm>

namespace demens::ensemble {

SharedCounters::SharedCounters(MPI_Comm communicator, int count) : communicator_(communicator)
{
    bool const is_root = rank_of(communicator) == 0;
    std::int64_t* counters = nullptr;
    MPI_Win_allocate(is_root ? count * static_cast<MPI_Aint>(sizeof(std::int64_t)) : 0, sizeof(std::int64_t),
                     MPI_INFO_NULL, communicator, &counters, &window_);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
    if (is_root)
        std::fill_n(counters, count, 0);
    MPI_Win_sync(window_);
    MPI_Barrier(communicator);
}

SharedCounters::~SharedCounters()
{
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
}

std::int64_t SharedCounters::add(int counter, std::int64_t amount)
{
    std::int64_t before = 0;
    MPI_Fetch_and_op(&amount, &before, MPI_INT64_T, 0, counter, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
}

void SharedCounters::progress() const
{
    int arrived = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, communicator_, &arrived, MPI_STATUS_IGNORE);
}

} // namespace demens::ensemble
