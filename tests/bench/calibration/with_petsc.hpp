#pragma once

#include "tao_calib/solver/petsc_session.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <memory>
#include <mpi.h>

namespace demens::bench {

//! Runs a program between the beginning and the end of MPI and PETSc. \return its exit code
template <class Program>
int with_petsc(int argc, char** argv, Program const& program)
{
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    tao_calib::PetscEnvironment::session() = std::make_unique<tao_calib::PetscSession>();
    int const code = program();
    tao_calib::PetscEnvironment::session().reset();
    MPI_Finalize();
    return code;
}

} // namespace demens::bench
