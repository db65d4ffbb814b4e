#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/unit_cube.hpp"

namespace demens::tao_calib {

//! Slopes of a function of the unit cube by central differences within it, exact for polynomials of the
//! second degree but beside a face of the cube [values x factors].
Eigen::MatrixXd central_slopes(std::function<Eigen::VectorXd(Eigen::VectorXd const&)> const& of,
                               Eigen::VectorXd const& point);

//! Gauss-Newton steps from a minimum that a solver ended at within its tolerances, with central slopes.
Eigen::VectorXd polished(LeastSquaresProblem const& problem, UnitCube const& cube, Eigen::VectorXd point);

} // namespace demens::tao_calib
