#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/unit_cube.hpp"

namespace demens::tao_calib {

//! Gauss-Newton steps from a minimum that a solver ended at within its tolerances. Slopes are central
//! differences, exact for polynomials of the second degree.
Eigen::VectorXd polished(LeastSquaresProblem const& problem, UnitCube const& cube, Eigen::VectorXd point);

} // namespace demens::tao_calib
