#pragma once

#include "tao_calib/solver/petsc_session.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <mpi.h>

namespace demens::tao_calib {

//! MPI and PETSc for the tests of one program.
class PetscEnvironment : public ::testing::Environment
{
  public:
    void SetUp() override
    {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        session() = std::make_unique<PetscSession>();
    }
    void TearDown() override
    {
        session().reset();
        MPI_Finalize();
    }
    static std::unique_ptr<PetscSession>& session()
    {
        static std::unique_ptr<PetscSession> instance;
        return instance;
    }
};

inline auto* const petsc_environment = ::testing::AddGlobalTestEnvironment(new PetscEnvironment);

} // namespace demens::tao_calib
