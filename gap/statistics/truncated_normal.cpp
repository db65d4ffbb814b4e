#include "gap/statistics/truncated_normal.hpp"

#include "gap/statistics/gaussian.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::gap {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TruncatedNormal::TruncatedNormal(std::vector<bool> one_signed, VectorXd mean, MatrixXd const& covariance)
    : one_signed_(std::move(one_signed)), mean_(std::move(mean)), root_(covariance.llt().matrixL())
{
}

VectorXd TruncatedNormal::at(VectorXd const& cube) const
{
    VectorXd x(mean_.size());
    for (Eigen::Index k = 0; k < x.size(); ++k)
        x[k] = upper_tail_quantile(std::log(cube[k]) + log_room(x, k));
    VectorXd u = mean_ + root_.triangularView<Eigen::Lower>() * x;
    for (Eigen::Index k = 0; k < u.size(); ++k)
        if (one_signed_[k])
            u[k] = std::max(u[k], 0.0); // rounding
    return u;
}

double TruncatedNormal::log_density(VectorXd const& u) const
{
    VectorXd const x = root_.triangularView<Eigen::Lower>().solve(u - mean_);
    double sum = -0.5 * x.squaredNorm();
    for (Eigen::Index k = 0; k < x.size(); ++k)
        sum -= 0.5 * std::log(2 * std::numbers::pi) + std::log(root_(k, k)) + log_room(x, k);
    return sum;
}

double TruncatedNormal::log_room(VectorXd const& x, Eigen::Index k) const
{
    if (!one_signed_[k])
        return 0;
    return log_upper_tail(-(mean_[k] + root_.row(k).head(k).dot(x.head(k))) / root_(k, k));
}

//! ln of the probability that two normal variables with precision H and mean m are positive: one by its
//! quantiles, evenly spread, the other exactly.
double log_both_positive(VectorXd const& mean, MatrixXd const& covariance)
{
    constexpr int points = 48;
    MatrixXd const root = covariance.llt().matrixL();
    double const first = log_upper_tail(-mean[0] / root(0, 0));
    VectorXd logs(points);
    for (int i = 0; i < points; ++i) {
        double const even =
            (i + 0.5) / points; // the midpoint rule in it, for shares with no slope at the ends
        double const x = upper_tail_quantile(first + std::log(even * even * (3 - 2 * even)));
        logs[i] = std::log(6 * even * (1 - even)) + log_upper_tail(-(mean[1] + root(1, 0) * x) / root(1, 1));
    }
    return first + log_sum_exp(logs) - std::log(static_cast<double>(points));
}

VectorXd cube_point(int point, int points, Eigen::Index dimensions)
{
    VectorXd cube(dimensions);
    cube[0] = (point + 0.5) / points;
    if (dimensions > 1) {
        double const along = 0.5 + point / std::numbers::phi;
        cube[1] = along - std::floor(along);
        cube[1] = std::clamp(cube[1], 0.1 / points, 1 - 0.1 / points);
    }
    return cube;
}

} // namespace demens::gap
