#include "demens/observe/time_average.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace demens::observe {
namespace {

double plain_mean(std::vector<double> const& samples)
{
    assert(!samples.empty());
    double sum = 0;
    for (double const sample : samples)
        sum += sample;
    return sum / static_cast<double>(samples.size());
}

//! Mean product of deviations that are `lag` samples apart, over all samples (biased, so that it falls to 0).
double autocovariance(std::vector<double> const& samples, double mean, std::size_t lag)
{
    double sum = 0;
    for (std::size_t k = lag; k < samples.size(); ++k)
        sum += (samples[k] - mean) * (samples[k - lag] - mean);
    return sum / static_cast<double>(samples.size());
}

//! How many independent samples the correlated ones are worth.
double independent_samples(std::vector<double> const& samples)
{
    return static_cast<double>(samples.size()) / (2 * autocorrelation_time(samples));
}

//! Variance about the sample mean, corrected for the mean being that of `independent` samples.
double variance(std::vector<double> const& samples, double mean, double independent)
{
    return autocovariance(samples, mean, 0) * independent / (independent - 1);
}

} // namespace

double autocorrelation_time(std::vector<double> const& samples)
{
    double const mean = plain_mean(samples), variance = autocovariance(samples, mean, 0);
    if (samples.size() < 2 || !(variance > 0))
        return 0.5;
    double time = 0.5;
    for (std::size_t lag = 1; lag < samples.size(); ++lag) {
        double const correlation = autocovariance(samples, mean, lag) / variance;
        if (correlation <= 0)
            break;
        time += correlation;
    }
    return time;
}

Estimate mean_of(std::vector<double> const& samples)
{
    double const mean = plain_mean(samples);
    double const independent = std::max(2.0, independent_samples(samples));
    return {mean, std::sqrt(variance(samples, mean, independent) / independent)};
}

Estimate standard_deviation_of(std::vector<double> const& samples)
{
    double const mean = plain_mean(samples);
    double const sd = std::sqrt(variance(samples, mean, std::max(2.0, independent_samples(samples))));
    std::vector<double> squares;
    for (double const sample : samples)
        squares.push_back((sample - mean) * (sample - mean));
    return {sd, sd > 0 ? mean_of(squares).standard_error / (2 * sd) : 0.0};
}

} // namespace demens::observe
