#include "demens/observe/avalanches.hpp"

#include <cassert>

namespace demens::observe {
namespace {

struct Moments
{
    Estimate mean, sd;
};

//! Of one value an avalanche.
Moments moments(std::vector<double> const& values, std::vector<double> const& series)
{
    if (values.size() >= 3)
        return {mean_of(values), standard_deviation_of(values)};
    double const spread = standard_deviation_of(series).value;
    return {{mean_of(values).value, spread}, {0, spread}};
}

//! Avalanches per unit of time from the times between breaks, whose scatter gives the standard error.
Estimate rate_of(std::vector<Avalanche> const& avalanches, double interval)
{
    std::vector<double> between;
    for (std::size_t k = 1; k < avalanches.size(); ++k)
        between.push_back(interval *
                          static_cast<double>(avalanches[k].break_at - avalanches[k - 1].break_at));
    Estimate const time = mean_of(between);
    return {1 / time.value, time.standard_error / (time.value * time.value)};
}

} // namespace

std::vector<Avalanche> find_avalanches(std::vector<double> const& series, double prominence)
{
    assert(prominence > 0);
    std::vector<Avalanche> found;
    if (series.empty())
        return found;
    // One extreme so far at a time: the lowest value, until the series rises from it by the prominence; then
    // the highest, until it falls.
    std::size_t lowest = 0, highest = 0;
    bool rising = false, broken = false;
    for (std::size_t k = 1; k < series.size(); ++k) {
        if (rising) {
            if (series[k] > series[highest])
                highest = k;
            if (series[highest] - series[k] >= prominence) {
                rising = false;
                broken = true;
                lowest = k;
            }
        } else {
            if (series[k] < series[lowest])
                lowest = k;
            if (series[k] - series[lowest] >= prominence) {
                if (broken)
                    found.push_back({highest, lowest});
                rising = true;
                highest = k;
            }
        }
    }
    return found;
}

AvalancheStatistics avalanche_statistics(std::vector<double> const& series, double interval,
                                         double prominence)
{
    auto const avalanches = find_avalanches(series, prominence);
    AvalancheStatistics statistics;
    statistics.count = avalanches.size();
    if (avalanches.empty()) {
        statistics.break_mean = statistics.rest_mean = mean_of(series);
        return statistics;
    }
    std::vector<double> breaks, rests, falls;
    for (auto const& [break_at, rest_at] : avalanches) {
        breaks.push_back(series[break_at]);
        rests.push_back(series[rest_at]);
        falls.push_back(series[break_at] - series[rest_at]);
    }
    auto const at_break = moments(breaks, series), at_rest = moments(rests, series),
               fall = moments(falls, series);
    statistics.break_mean = at_break.mean, statistics.break_sd = at_break.sd;
    statistics.rest_mean = at_rest.mean, statistics.rest_sd = at_rest.sd;
    statistics.fall_mean = fall.mean, statistics.fall_sd = fall.sd;
    double const duration = interval * static_cast<double>(series.size() - 1);
    double const count = static_cast<double>(avalanches.size());
    statistics.rate =
        avalanches.size() >= 3 ? rate_of(avalanches, interval) : Estimate{count / duration, count / duration};
    return statistics;
}

} // namespace demens::observe
