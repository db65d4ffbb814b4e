#pragma once

#include <functional>
#include <mpi.h>

namespace demens::cli {

//! Does something on all ranks of a world of its own, and tells once what goes wrong. \return exit code, the
//! same on all ranks
int on_all_ranks(std::function<int()> const& act);

//! MPI for what one rank does with TAO.
struct MpiOnOneRank
{
    MpiOnOneRank() { MPI_Init(nullptr, nullptr); }
    ~MpiOnOneRank() { MPI_Finalize(); }
    MpiOnOneRank(MpiOnOneRank const&) = delete;
    MpiOnOneRank& operator=(MpiOnOneRank const&) = delete;
};

} // namespace demens::cli
