#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace demens::tao_calib {

//! A Gaussian process with a given covariance, conditioned on data, about a trend whose coefficients are
//! unknown (generalised least squares; Rasmussen and Williams 2006, sections 2.2 and 2.7).
class Kriging
{
  public:
    //! \param covariance of the data, noise included [n x n]; \param trend functions at the data [n x q], q
    //! may be 0
    Kriging(Eigen::MatrixXd const& covariance, Eigen::MatrixXd const& trend, Eigen::VectorXd const& values);

    //! Mean at a point with these covariances with the data [n] and trend functions [q].
    double mean(Eigen::VectorXd const& covariances, Eigen::VectorXd const& trend) const;
    //! Variance there, of the process without noise; `own` is its variance before any data.
    double variance(Eigen::VectorXd const& covariances, Eigen::VectorXd const& trend, double own) const;

    //! What each value counts in the mean there [n].
    Eigen::VectorXd shares(Eigen::VectorXd const& covariances, Eigen::VectorXd const& trend) const;

    //! Weights of the covariances in the mean [n]; its gradient is theirs times the covariances' gradients.
    Eigen::VectorXd const& weights() const { return weights_; }
    Eigen::VectorXd const& trend_coefficients() const { return coefficients_; }
    //! Projector P of restricted likelihood: P y = weights, P F = 0 [n x n].
    Eigen::MatrixXd const& projector() const { return projector_; }
    //! y'P y
    double quadratic_form() const { return quadratic_form_; }
    //! log|K| + log|F'K^-1 F|
    double log_determinants() const { return log_determinants_; }
    //! Value less what the other data predict there [n] (Dubrule 1983).
    Eigen::VectorXd leave_one_out_errors() const { return weights_.cwiseQuotient(projector_.diagonal()); }
    //! Whether the covariance is positive definite in double precision.
    bool sound() const { return sound_; }

  private:
    Eigen::LLT<Eigen::MatrixXd> factor_, trend_factor_;
    Eigen::MatrixXd solved_trend_; //!< K^-1 F
    Eigen::MatrixXd projector_;
    Eigen::VectorXd weights_, coefficients_;
    double quadratic_form_ = 0, log_determinants_ = 0;
    bool sound_ = false;
};

} // namespace demens::tao_calib
