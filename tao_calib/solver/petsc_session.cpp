#include "tao_calib/solver/petsc_session.hpp"

#include <mpi.h>
#include <petscsys.h>
#include <stdexcept>

namespace demens::tao_calib {

PetscSession::PetscSession()
{
    int ready = 0;
    MPI_Initialized(&ready);
    if (!ready)
        throw std::runtime_error("PETSc is started before MPI: call MPI_Init_thread first");
    PetscBool inside = PETSC_FALSE;
    if (PetscInitialized(&inside) == 0 && inside) {
        begins_ = false;
        return;
    }
    PETSC_COMM_WORLD = MPI_COMM_SELF;
    // No files of the user and no handlers of PETSc: they would change results and hide the program's own
    // signals.
    char program[] = "demens", no_signals[] = "-no_signal_handler", no_file[] = "-skip_petscrc";
    char* words[] = {program, no_signals, no_file, nullptr};
    char** arguments = words;
    int count = 3;
    if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0)
        throw std::runtime_error("PETSc could not be initialised");
    // Errors come back as codes, without a trace on the terminal.
    if (PetscPushErrorHandler(PetscReturnErrorHandler, nullptr) != 0)
        throw std::runtime_error("PETSc refused an error handler");
}

PetscSession::~PetscSession()
{
    if (!begins_)
        return;
    (void)PetscPopErrorHandler();
    (void)PetscFinalize();
}

} // namespace demens::tao_calib
