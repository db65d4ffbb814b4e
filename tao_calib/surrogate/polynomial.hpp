#pragma once

#include "tao_calib/surrogate/run_error.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

namespace demens::tao_calib {

//! Polynomial of at most second order by weighted least squares (QR with column pivoting).
class Polynomial : public Surrogate
{
  public:
    //! Number of coefficients of a kind (constant to quadratic) in k factors.
    static int terms(SurrogateKind kind, int factors);
    //! Whether the samples determine all coefficients and leave at least one degree of freedom.
    static bool can_fit(SurrogateKind kind, Samples const& samples);
    //! Of the kinds up to `richest` that the samples allow, the one that predicts left-out locations best.
    static std::unique_ptr<Polynomial> best_up_to(SurrogateKind richest, Samples const& samples);

    //! Fits exactly that kind; can_fit() must hold.
    Polynomial(SurrogateKind kind, Samples const& samples);

    SurrogateKind kind() const override { return kind_; }
    double value(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd gradient(Eigen::VectorXd const& point) const override;
    double standard_deviation(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd const& leave_one_out_errors() const override { return leave_one_out_; }
    double degrees_of_freedom() const override { return error_.degrees_of_freedom; }

    //! Weighted sum of squared residuals of the fit.
    double residual_sum_of_squares() const { return residual_sum_of_squares_; }

  private:
    SurrogateKind kind_;
    Eigen::VectorXd coefficients_;
    Eigen::MatrixXd covariance_; //!< of the coefficients, for single runs of variance one
    Eigen::VectorXd leave_one_out_;
    double residual_sum_of_squares_ = 0;
    RunError error_;
};

} // namespace demens::tao_calib
