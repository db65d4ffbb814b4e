#include "ensemble/mpi/patience.hpp"

#include <algorithm>
#include <thread>

namespace demens::ensemble {

void Patience::pause()
{
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, std::chrono::microseconds(20000));
}

void wait_patiently(MPI_Request& request)
{
    int arrived = 0;
    for (Patience patience;; patience.pause()) {
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived)
            return;
    }
}

void patient_barrier(MPI_Comm communicator)
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(communicator, &request);
    wait_patiently(request);
}

} // namespace demens::ensemble
