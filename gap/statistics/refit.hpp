#pragma once

#include "gap/statistics/amplitude_integral.hpp"
#include "gap/statistics/projection.hpp"

namespace demens::gap {

//! A fit anew of the factors, and of amplitudes, to residuals r = y - m0.
struct Refit
{
    Eigen::VectorXd factors;           //!< d [p, unit-cube]
    Eigen::MatrixXd factor_covariance; //!< given the amplitudes [p x p]
    Eigen::VectorXd amplitudes;        //!< own units [K]
    Eigen::VectorXd residual;          //!< e, what is left [n, response units]
    double misfit;                     //!< squares of residual and of d, each over its covariance
};

//! Of the factors alone, with their prior: d = Lambda J' C^-1 r, e = Sigma_F C^-1 r.
Refit refit(Evidence const& evidence, Projection const& projection, Eigen::VectorXd const& residual);

//! V, covariance of e where the base model is right: Sigma_F C^-1 Sigma_F [n x n].
Eigen::MatrixXd refitted_covariance(Projection const& projection);

//! Of factors and amplitudes, on the model with T and q.
Refit refit_with(Evidence const& evidence, Projection const& projection,
                 std::vector<Signature> const& effects, Eigen::VectorXd const& residual,
                 AmplitudePrior prior = AmplitudePrior::typical);

//! How the cells change: a s + J d + a T d + a^2 q summed over effects [n, response units].
Eigen::VectorXd change(Evidence const& evidence, std::vector<Signature> const& effects,
                       Eigen::VectorXd const& amplitudes, Eigen::VectorXd const& factors);

} // namespace demens::gap
