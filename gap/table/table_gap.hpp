#pragma once

#include "gap/statistics/locate.hpp"
#include "gap/table/measured_points.hpp"
#include "tao_calib/solver/least_squares.hpp"

//! Whether one set of factors meets all that was measured at several conditions, by a table of another
//! program's runs.
namespace demens::gap {

//! A value that was measured.
struct TableCell
{
    int point, response;
};

//! Where measurements are met best: all of them, or those of one point.
struct TableOptimum
{
    Eigen::VectorXd values;       //!< all factors, own units; those that points know at the first point
    Eigen::VectorXd lower, upper; //!< a standard deviation to either side [free factors, own units]
    double misfit;                //!< squares of deviations over their variances
};

struct TableGap
{
    std::vector<TableCell> cells;
    Evidence evidence; //!< about the best set for all
    TableOptimum best;
    std::vector<TableOptimum> own; //!< of each point by itself
    Located located;
    //! Above this form error, over the size of a response, nothing is beyond chance; 0: nothing is without.
    double form_error_that_hides_it;
    std::vector<std::string> assumed;
};

//! PETSc must be initialised. \throws InputError
TableGap table_gap(MeasuredTable const& measured, tao_calib::LeastSquaresSolver const& solver);

} // namespace demens::gap
