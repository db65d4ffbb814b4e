#pragma once

#include "tao_calib/solver/bounded_minimum.hpp"
#include "tao_calib/solver/least_squares.hpp"

namespace demens::tao_calib {

//! A minimiser of NLopt that looks at the sum of squares alone.
class DerivativeFree : public LeastSquaresSolver
{
  public:
    //! \param minimiser one that needs no gradient
    explicit DerivativeFree(Minimiser minimiser) : minimiser_(minimiser) {}
    LeastSquaresResult minimise(LeastSquaresProblem const& problem, Eigen::VectorXd const& start,
                                LeastSquaresSettings const& settings) const override;

  private:
    Minimiser minimiser_;
};

} // namespace demens::tao_calib
