#pragma once

#include "tao_calib/surrogate/run_error.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

namespace demens::tao_calib {

//! Cubic radial basis functions with a linear tail: s(x) = sum_i c_i |x - x_i|^3 + d_0 + d'x with sum_i c_i =
//! 0 and sum_i c_i x_i = 0. In one dimension the natural cubic spline. Smoothed like a smoothing spline,
//! since simulated packings scatter; the smoothing is chosen by leave-one-out.
class RadialBasis : public Surrogate
{
  public:
    //! Whether the samples determine the linear tail and leave at least one degree of freedom.
    static bool can_fit(Samples const& samples);

    //! Fits with the smoothing that predicts left-out locations best; can_fit() must hold.
    explicit RadialBasis(Samples const& samples);
    //! Fits with a given smoothing, 0 to interpolate.
    RadialBasis(Samples const& samples, double smoothing);

    SurrogateKind kind() const override { return SurrogateKind::radial_basis; }
    double value(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd gradient(Eigen::VectorXd const& point) const override;
    double standard_deviation(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd const& leave_one_out_errors() const override { return leave_one_out_; }
    double degrees_of_freedom() const override { return error_.degrees_of_freedom; }
    double smoothing() const override { return smoothing_; }

  private:
    struct System;
    void solve(System const& system, Samples const& samples, double smoothing);

    Eigen::MatrixXd points_;       //!< [n x k]
    Eigen::VectorXd coefficients_; //!< [n], c
    Eigen::VectorXd tail_;         //!< [k + 1], d
    //! [(n + k + 1) x n] coefficients and tail per standard deviation of each value, for single runs of
    //! variance one
    Eigen::MatrixXd influence_;
    Eigen::VectorXd leave_one_out_;
    double smoothing_ = 0;
    RunError error_;
};

} // namespace demens::tao_calib
