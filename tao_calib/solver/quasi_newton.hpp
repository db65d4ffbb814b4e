#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/solver/petsc_session.hpp"

namespace demens::tao_calib {

//! PETSc TAO's bounded quasi-Newton line search (BQNLS) on the sum of squares. The gradient is that of the
//! problem's jacobian, or central differences where it has none.
class QuasiNewton : public LeastSquaresSolver
{
  public:
    //! The session must outlive the solver.
    explicit QuasiNewton(PetscSession const&) {}

    //! Exceptions of the residual function pass through. \throws std::runtime_error when PETSc fails
    LeastSquaresResult minimise(LeastSquaresProblem const& problem, Eigen::VectorXd const& start,
                                LeastSquaresSettings const& settings) const override;
};

//! Gradient of the sum of squares at a point of the unit cube with these residuals.
Eigen::VectorXd sum_of_squares_gradient(LeastSquaresProblem const& problem, Eigen::VectorXd const& point,
                                        Eigen::VectorXd const& residuals);

} // namespace demens::tao_calib
