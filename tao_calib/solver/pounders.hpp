#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/solver/petsc_session.hpp"

namespace demens::tao_calib {

//! PETSc TAO's POUNDERS (Wild 2017): quadratic models of every residual inside a trust region.
class Pounders : public LeastSquaresSolver
{
  public:
    //! The session must outlive the solver.
    explicit Pounders(PetscSession const&) {}

    //! Exceptions of the residual function pass through. \throws std::runtime_error when PETSc fails
    LeastSquaresResult minimise(LeastSquaresProblem const& problem, Eigen::VectorXd const& start,
                                LeastSquaresSettings const& settings) const override;
};

} // namespace demens::tao_calib
