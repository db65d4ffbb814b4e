#pragma once

#include <vector>

namespace demens::observe {

//! A number read off a run and how far it may be off because the run was short.
struct Estimate
{
    double value = 0;
    double standard_error = 0;
};

// All of these take at least one sample.

//! Integrated autocorrelation time of equally spaced samples, in samples: 1/2 + sum of the autocorrelations
//! before the first that is not positive (the initial positive sequence of Geyer 1992, with single lags). 1/2
//! for independent samples; too long rather than too short where the series swings.
double autocorrelation_time(std::vector<double> const& samples);

//! Mean of equally spaced, correlated samples. Its standard error is that of as many independent samples as
//! the run holds autocorrelation times twice over; with fewer than two of these, it is the standard
//! deviation.
Estimate mean_of(std::vector<double> const& samples);
//! Standard deviation of equally spaced, correlated samples; its standard error follows from that of the mean
//! squared deviation.
Estimate standard_deviation_of(std::vector<double> const& samples);

} // namespace demens::observe
