#pragma once

#include <Eigen/Core>

namespace demens::tao_calib {

//! The error of a single run, scatter and lack of fit together, that leave-one-out errors tell of. An error
//! left out is that of the location itself and that of what the others predict there, so that it is larger
//! than the run's own: e = D y has the variance error^2 sum_j D_ij^2/w_j where each of the values y_j is a
//! mean over w_j runs. Each squared error counts over what it should be for an error of one.
struct RunError
{
    double sd = 0;
    double degrees_of_freedom =
        0; //!< by Satterthwaite's rule: those of the chi-square with its relative variance
};

//! \param operation D, by which the errors follow from the values, its diagonal 1 [n x n]
//! \param weights runs behind each value [n]
RunError run_error(Eigen::VectorXd const& leave_one_out_errors, Eigen::MatrixXd const& operation,
                   Eigen::VectorXd const& weights);

//! The same for least squares, where the variance of an error left out is error^2/w_i/(1 - h_i).
//! \param leverages h [n]; \param coefficients of the fit
RunError run_error_of_regression(Eigen::VectorXd const& leave_one_out_errors,
                                 Eigen::VectorXd const& leverages, Eigen::VectorXd const& weights,
                                 int coefficients);

} // namespace demens::tao_calib
