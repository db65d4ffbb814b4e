#pragma once

#include <chrono>
#include <mpi.h>

//! Waiting without taking the core, which MPI's own waiting does.
namespace demens::ensemble {

//! Pauses that get longer, up to 20 ms.
class Patience
{
  public:
    void pause();

  private:
    std::chrono::microseconds next_{50};
};

void wait_patiently(MPI_Request& request);
//! Collective.
void patient_barrier(MPI_Comm communicator);

} // namespace demens::ensemble
