#pragma once

#include "demens/base/random.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace demens::tao_calib {

//! A function at n random points of the unit cube.
inline Samples sampled(int n, int k, std::function<double(Eigen::VectorXd const&)> const& f,
                       std::uint64_t seed = 1)
{
    RandomStream random(seed);
    Samples samples{Eigen::MatrixXd(n, k), Eigen::VectorXd(n), Eigen::VectorXd::Ones(n)};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < k; ++j)
            samples.points(i, j) = random.uniform();
        samples.values[i] = f(samples.points.row(i).transpose());
    }
    return samples;
}

inline double wavy(Eigen::VectorXd const& x)
{
    return std::sin(3 * x[0]) + x[0] * x[1] * x[1] - std::exp(0.5 * x[2]);
}

inline Samples without(Samples const& samples, int left_out)
{
    Samples rest{Eigen::MatrixXd(samples.points.rows() - 1, samples.points.cols()),
                 Eigen::VectorXd(samples.values.size() - 1), Eigen::VectorXd(samples.values.size() - 1)};
    for (int i = 0, next = 0; i < samples.values.size(); ++i) {
        if (i == left_out)
            continue;
        rest.points.row(next) = samples.points.row(i);
        rest.values[next] = samples.values[i];
        rest.weights[next++] = samples.weights[i];
    }
    return rest;
}

inline void expect_gradient_matches_differences(Surrogate const& surrogate, int k)
{
    RandomStream random(7);
    constexpr double h = 1e-5;
    for (int trial = 0; trial < 20; ++trial) {
        Eigen::VectorXd x(k);
        for (int j = 0; j < k; ++j)
            x[j] = random.uniform();
        Eigen::VectorXd const gradient = surrogate.gradient(x);
        for (int j = 0; j < k; ++j) {
            Eigen::VectorXd const step = h * Eigen::VectorXd::Unit(k, j);
            EXPECT_NEAR(gradient[j], (surrogate.value(x + step) - surrogate.value(x - step)) / (2 * h), 1e-7);
        }
    }
}

//! Bell of standard deviation one: the sum of twelve uniform numbers.
inline double normal(RandomStream& random)
{
    double sum = -6;
    for (int i = 0; i < 12; ++i)
        sum += random.uniform();
    return sum;
}

} // namespace demens::tao_calib
