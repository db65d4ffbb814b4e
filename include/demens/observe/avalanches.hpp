#pragma once

#include "demens/observe/time_average.hpp"

#include <cstddef>
#include <vector>

namespace demens::observe {

//! A fall from a local maximum (break) to the next minimum (rest), as positions in a series.
struct Avalanche
{
    std::size_t break_at, rest_at;
};

//! Falls by at least `prominence`, and not interrupted by a rise of as much. Only whole ones: the series must
//! have risen by the prominence before the break and after the rest.
std::vector<Avalanche> find_avalanches(std::vector<double> const& series, double prominence);

//! What the avalanches of a run have in common, in the unit of the series.
struct AvalancheStatistics
{
    Estimate break_mean, break_sd; //!< value before the fall
    Estimate rest_mean, rest_sd;   //!< value after it
    Estimate fall_mean, fall_sd;   //!< difference of the two
    Estimate rate;                 //!< avalanches per unit of time
    std::size_t count = 0;
};

//! Statistics of the avalanches of a series with one sample every `interval`. Without an avalanche the bed
//! flows evenly: break and rest are the mean of the series, the fall is 0. With fewer than three, the
//! standard error of the means is the standard deviation of the series.
AvalancheStatistics avalanche_statistics(std::vector<double> const& series, double interval,
                                         double prominence);

} // namespace demens::observe
