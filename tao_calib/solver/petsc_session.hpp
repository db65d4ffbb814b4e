#pragma once

namespace demens::tao_calib {

//! PETSc on this rank alone, from construction to destruction; at most one at a time. MPI must be initialised
//! before and finalised after. Leaves signals and the error handlers of MPI as they are. \throws
//! std::runtime_error
class PetscSession
{
  public:
    PetscSession();
    ~PetscSession();
    PetscSession(PetscSession const&) = delete;
    PetscSession& operator=(PetscSession const&) = delete;
};

} // namespace demens::tao_calib
