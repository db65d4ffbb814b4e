#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/solver/petsc_session.hpp"

#include <memory>
#include <string>

namespace demens::tao_calib {

//! The solver that works on the surrogate for a word of `[solver] kind`: the one named, POUNDERS for a word
//! that names a way to choose points. The session must outlive it.
std::unique_ptr<LeastSquaresSolver> surrogate_solver(std::string const& kind, PetscSession const& session);

} // namespace demens::tao_calib
