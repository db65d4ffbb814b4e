#pragma once

#include <cstdint>
#include <mpi.h>

namespace demens::ensemble {

//! Counters in the memory of rank 0 that every rank adds to without rank 0 taking part (MPI one-sided
//! operations): groups take their next run from one, so that nobody has to sit and hand runs out.
//! Construction and destruction are collective.
class SharedCounters
{
  public:
    SharedCounters(MPI_Comm communicator, int count);
    ~SharedCounters();
    SharedCounters(SharedCounters const&) = delete;
    SharedCounters& operator=(SharedCounters const&) = delete;

    //! Adds and gives back the value before.
    std::int64_t add(int counter, std::int64_t amount);
    std::int64_t value(int counter) { return add(counter, 0); }
    //! Lets MPI answer others; called now and then by a rank that computes for long.
    void progress() const;

  private:
    MPI_Comm communicator_;
    MPI_Win window_ = MPI_WIN_NULL;
};

} // namespace demens::ensemble
