#pragma once

#include "tao_calib/solver/least_squares.hpp"
#include "tao_calib/unit_cube.hpp"

#include <vector>

namespace demens::tao_calib {

//! A minimum found from one or more starts.
struct LocalMinimum
{
    Eigen::VectorXd point; //!< unit cube, feasible
    double sum_of_squares;
};

//! The minimum that a solver finds from one start. Linear constraints enter by projection: at x the residuals
//! are those of the nearest feasible point, followed by its distance from x, so that a minimum is feasible
//! and exact.
LocalMinimum minimum_from(LeastSquaresSolver const& solver, LeastSquaresProblem const& problem,
                          UnitCube const& cube, Eigen::VectorXd const& start,
                          LeastSquaresSettings const& settings = {});

//! Solves from every start within the feasible part of the cube and returns the minima that lie further apart
//! than `separation`, best first.
std::vector<LocalMinimum> distinct_minima(LeastSquaresSolver const& solver,
                                          LeastSquaresProblem const& problem, UnitCube const& cube,
                                          std::vector<Eigen::VectorXd> const& starts, double separation);

//! `count` feasible points spread over the cube, each far from the others and from `taken`.
std::vector<Eigen::VectorXd> spread_points(UnitCube const& cube, int count,
                                           std::vector<Eigen::VectorXd> taken, std::uint64_t seed);

} // namespace demens::tao_calib
