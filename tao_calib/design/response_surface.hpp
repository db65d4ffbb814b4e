#pragma once

#include "tao_calib/design/fractional_factorial.hpp"

namespace demens::tao_calib {

//! Grid of all combinations, coordinates 0 ... levels[k]-1, the first factor changing fastest [points x
//! factors].
Eigen::MatrixXi full_factorial(std::vector<int> const& levels);

//! Axial distance at which the variance of the prediction depends on the distance from the centre only.
double rotatable_axial_distance(int cube_points);

//! Cube at -1 and +1 and two points on every axis, coded, without centre points (Box and Wilson 1951) [points
//! x factors].
Eigen::MatrixXd central_composite(FractionalFactorial const& cube, double axial_distance);

//! Middles of edges or faces of the cube, coded, without centre points (Box and Behnken 1960); 3 to 7
//! factors. \throws InputError
Eigen::MatrixXd box_behnken(int factors);

} // namespace demens::tao_calib
