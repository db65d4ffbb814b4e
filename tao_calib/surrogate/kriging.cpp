#include "tao_calib/surrogate/kriging.hpp"

#include <algorithm>

namespace demens::tao_calib {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Kriging::Kriging(MatrixXd const& covariance, MatrixXd const& trend, VectorXd const& values)
    : factor_(covariance)
{
    auto const n = covariance.rows(), q = trend.cols();
    sound_ = factor_.info() == Eigen::Success;
    if (!sound_)
        return;
    projector_ = factor_.solve(MatrixXd::Identity(n, n));
    log_determinants_ = 2 * factor_.matrixLLT().diagonal().array().log().sum();
    coefficients_ = VectorXd::Zero(q);
    if (q > 0) {
        solved_trend_ = projector_ * trend;
        trend_factor_.compute(trend.transpose() * solved_trend_);
        sound_ = trend_factor_.info() == Eigen::Success;
        if (!sound_)
            return;
        log_determinants_ += 2 * trend_factor_.matrixLLT().diagonal().array().log().sum();
        coefficients_ = trend_factor_.solve(solved_trend_.transpose() * values);
        projector_ -= solved_trend_ * trend_factor_.solve(solved_trend_.transpose());
    }
    weights_ = projector_ * values;
    quadratic_form_ = values.dot(weights_);
}

double Kriging::mean(VectorXd const& covariances, VectorXd const& trend) const
{
    return trend.dot(coefficients_) + covariances.dot(weights_);
}

VectorXd Kriging::shares(VectorXd const& covariances, VectorXd const& trend) const
{
    VectorXd result = projector_ * covariances;
    if (trend.size() > 0)
        result += solved_trend_ * trend_factor_.solve(trend);
    return result;
}

double Kriging::variance(VectorXd const& covariances, VectorXd const& trend, double own) const
{
    double variance = own - covariances.dot(factor_.solve(covariances));
    if (trend.size() > 0) {
        VectorXd const unexplained = trend - solved_trend_.transpose() * covariances;
        variance += unexplained.dot(trend_factor_.solve(unexplained));
    }
    return std::max(variance, 0.0);
}

} // namespace demens::tao_calib
