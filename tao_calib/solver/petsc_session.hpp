#pragma once

namespace demens::tao_calib {

//! PETSc on this rank alone, from construction to destruction. One inside another shares it. TAO does not
//! survive a second beginning in a process: who needs several in turn holds one around them. MPI must be
//! initialised before and finalised after. Leaves signals and the error handlers of MPI as they are. \throws
//! std::runtime_error
class PetscSession
{
  public:
    PetscSession();
    ~PetscSession();
    PetscSession(PetscSession const&) = delete;
    PetscSession& operator=(PetscSession const&) = delete;

  private:
    bool begins_ = true; //!< false inside another
};

} // namespace demens::tao_calib
