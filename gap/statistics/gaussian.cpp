#include "gap/statistics/gaussian.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace demens::gap {

double standard_normal(RandomStream& random)
{
    double const radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

Eigen::VectorXd standard_normals(Eigen::Index count, RandomStream& random)
{
    Eigen::VectorXd numbers(count);
    for (double& number : numbers)
        number = standard_normal(random);
    return numbers;
}

double log_upper_tail(double z)
{
    if (z < 20)
        return std::log(0.5 * std::erfc(z / std::numbers::sqrt2));
    double const r = 1 / (z * z); // Abramowitz and Stegun 26.2.12
    return -0.5 * z * z - std::log(z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(-r * (1 - 3 * r * (1 - 5 * r)));
}

double upper_tail_quantile(double log_probability)
{
    // Newton on the logarithm, which is concave: no step from the left overshoots by much.
    double z = log_probability < -1 ? std::sqrt(-2 * log_probability) - 1 : -8;
    if (log_probability >= -1)
        z = log_probability > -1e-3 ? -std::sqrt(-2 * std::log(-log_probability)) : -0.5;
    for (int step = 0; step < 60; ++step) {
        double const tail = log_upper_tail(z);
        double const slope = -std::exp(-0.5 * z * z - tail) / std::sqrt(2 * std::numbers::pi);
        double const change = std::clamp((log_probability - tail) / slope, -2.0, 2.0);
        z += change;
        if (std::abs(change) < 1e-13 * std::max(1.0, std::abs(z)))
            break;
    }
    return z;
}

double two_sided_p_value(double z)
{
    return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

double log_sum_exp(Eigen::VectorXd const& logs)
{
    double const largest = logs.maxCoeff();
    if (!std::isfinite(largest))
        return largest;
    return largest + std::log((logs.array() - largest).exp().sum());
}

Eigen::VectorXd normalised(Eigen::VectorXd const& logs)
{
    return (logs.array() - log_sum_exp(logs)).exp();
}

Eigen::MatrixXd square_root(Eigen::MatrixXd const& covariance)
{
    auto const n = covariance.rows();
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        double const pivot = covariance(j, j) - root.row(j).head(j).squaredNorm();
        if (!(pivot > 1e-13 * covariance(j, j)))
            continue; // given by those before it
        root(j, j) = std::sqrt(pivot);
        auto const rest = n - j - 1;
        root.col(j).tail(rest) = (covariance.col(j).tail(rest) -
                                  root.bottomLeftCorner(rest, j) * root.row(j).head(j).transpose()) /
                                 root(j, j);
    }
    return root;
}

double quantile(std::vector<double> numbers, double share)
{
    assert(!numbers.empty());
    std::sort(numbers.begin(), numbers.end());
    double const place = share * (static_cast<double>(numbers.size()) - 1);
    auto const lower = static_cast<std::size_t>(place);
    auto const upper = std::min(lower + 1, numbers.size() - 1);
    double const weight = place - static_cast<double>(lower);
    return (1 - weight) * numbers[lower] + weight * numbers[upper];
}

} // namespace demens::gap
