#pragma once

#include "tao_calib/solver/least_squares.hpp"

#include <cstdint>

namespace demens::tao_calib {

//! A genetic algorithm on the sum of squares: tournaments of two, blend crossover (Eshelman and Schaffer
//! 1993), bell-shaped mutation that narrows, the best two kept. Searches the whole cube; the start is one of
//! its first members. The same start gives the same bits.
class Genetic : public LeastSquaresSolver
{
  public:
    LeastSquaresResult minimise(LeastSquaresProblem const& problem, Eigen::VectorXd const& start,
                                LeastSquaresSettings const& settings) const override;
};

} // namespace demens::tao_calib
