#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace demens::observe {

//! The value that a share of a sample does not exceed; the sample is not empty.
inline double quantile_of(std::vector<double> sample, double share)
{
    auto const k = static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), sample.begin() + k, sample.end());
    return sample[static_cast<std::size_t>(k)];
}

//! Median of a sample, and how it scatters about it: 1.4826 times the median distance from it, the standard
//! deviation of what is normally distributed.
struct Middle
{
    double median, spread;
};
inline Middle middle_of(std::vector<double> sample)
{
    double const median = quantile_of(sample, 0.5);
    for (double& value : sample)
        value = std::abs(value - median);
    return {median, 1.4826 * quantile_of(std::move(sample), 0.5)};
}

} // namespace demens::observe
