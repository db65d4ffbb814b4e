#pragma once

#include "tao_calib/fit_table/table_fit.hpp"
#include "tao_calib/solver/least_squares.hpp"

namespace demens::tao_calib {

//! Where the predicted responses come closest to their targets.
struct FitOptimum
{
    Eigen::VectorXd values;    //!< all factors, own units; numbers of levels; NaN for blocks
    Eigen::VectorXd predicted; //!< [responses]
    double sum_of_squares;     //!< of deviations in scales
};

//! Distinct optima of the free factors, of every combination of free levels, best first; none without a
//! target, or where a response that has one is not fitted.
std::vector<FitOptimum> fit_optima(TableFit const& fit, LeastSquaresSolver const& solver,
                                   std::uint64_t seed = 1);

//! Part of the admissible region that hangs together.
struct AdmissiblePart
{
    Eigen::VectorXd lower, upper; //!< extent of the free factors, own units
    double share;                 //!< of the feasible range of the free factors
    Levels levels;                //!< of categorical factors [factors]
};

//! Points of a grid over the free factors at which every response with a tolerance is predicted within it.
//! With many factors a grid would be coarse or without end: then random points, whose parts are not told
//! apart.
struct AdmissibleRegion
{
    int points_per_factor = 0;         //!< 0: random points
    std::vector<AdmissiblePart> parts; //!< largest first

    double share() const;
    Eigen::VectorXd lower() const; //!< extent of all parts; there must be one
    Eigen::VectorXd upper() const;
};

//! \param grid_points about so many in all
AdmissibleRegion admissible_region(TableFit const& fit, int grid_points = 200000);

} // namespace demens::tao_calib
