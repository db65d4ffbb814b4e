#pragma once

#include "demens/base/random.hpp"

#include <Eigen/Core>
#include <vector>

//! The normal distribution: draws, tails, densities.
namespace demens::gap {

//! One number of N(0, 1); takes two of the stream (Box and Muller 1958).
double standard_normal(RandomStream& random);
Eigen::VectorXd standard_normals(Eigen::Index count, RandomStream& random);

//! ln P(x > z) of N(0, 1), exact also far out.
double log_upper_tail(double z);
//! The z with ln P(x > z) = log_probability.
double upper_tail_quantile(double log_probability);
//! P(|x| > |z|).
double two_sided_p_value(double z);

//! ln of the sum of exponentials.
double log_sum_exp(Eigen::VectorXd const& logs);
//! exp(logs) over their sum.
Eigen::VectorXd normalised(Eigen::VectorXd const& logs);

//! A normal distribution.
struct Gaussian
{
    Eigen::VectorXd mean;       //!< [m]
    Eigen::MatrixXd covariance; //!< [m x m]
};

//! The lower triangle L with L L' = covariance; defined also where it is singular, when rows of L are zero.
Eigen::MatrixXd square_root(Eigen::MatrixXd const& covariance);

//! Quantile of numbers by linear interpolation between the sorted ones; `share` from 0 to 1.
double quantile(std::vector<double> numbers, double share);

} // namespace demens::gap
