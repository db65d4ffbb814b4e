#pragma once

#include "ensemble/input/kinds.hpp"
#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/solver/petsc_session.hpp"

#include <memory>

namespace demens::tao_calib {

//! The solver that works on the surrogates. The session must outlive it.
std::unique_ptr<LeastSquaresSolver> surrogate_solver(ensemble::SolverKind kind, PetscSession const& session);

} // namespace demens::tao_calib
