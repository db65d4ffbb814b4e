#pragma once

#include "gap/statistics/evidence.hpp"

//! What even the right model would miss.
namespace demens::gap {

//! Covariance of what the right model would miss, by cause; each [n x n, products of response units].
struct Floor
{
    Eigen::MatrixXd experiment; //!< scatter of the measurements, over their number
    Eigen::MatrixXd seed;       //!< scatter of packings, over their number
    Eigen::MatrixXd surrogate;
    Eigen::MatrixXd form; //!< the true laws are not ours

    //! Sigma_F
    Eigen::MatrixXd total() const { return experiment + seed + surrogate + form; }
    //! Standard deviation of each cell [n, response units].
    Eigen::VectorXd deviations() const { return total().diagonal().cwiseSqrt(); }
};

//! \throws InputError for bad evidence.
Floor make_floor(Evidence const& evidence);

//! A covariance, and the share of the target in it.
struct Shrunk
{
    Eigen::MatrixXd covariance; //!< [m x m]
    double share;               //!< 0: all of it is the sample's, 1: no correlation is left
};

//! Covariance of rows of deviations [runs x m], shrunk towards uncorrelated ones (Ledoit and Wolf, J.
//! Multivariate Analysis 88:365, 2004, on deviations over their standard deviations, so that units do not
//! matter).
Shrunk shrunk_covariance(Eigen::MatrixXd const& deviations, int degrees_of_freedom);

//! K, correlation of form errors: Matern's of order 3/2 in the distance of the conditions over `length`
//! within a family of responses, none between families. Length 0: none between different conditions. [n x m]
Eigen::MatrixXd form_correlation(std::vector<Cell> const& rows, std::vector<Cell> const& columns,
                                 double length);

//! [n, response units]
Eigen::VectorXd scales(std::vector<Cell> const& cells);

} // namespace demens::gap
