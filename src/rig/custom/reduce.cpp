// What is made of the course of a reading.
#include "src/rig/custom/setup.hpp"

#include "demens/observe/surface.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>

namespace demens::rig::custom {
namespace {

double mean_of(std::vector<double> const& values)
{
    double mean = 0;
    for (double const value : values)
        mean += value / static_cast<double>(values.size());
    return mean;
}

double sd_of(std::vector<double> const& values)
{
    double const mean = mean_of(values);
    double squares = 0;
    for (double const value : values)
        squares += (value - mean) * (value - mean) / static_cast<double>(values.size());
    return std::sqrt(squares);
}

} // namespace

double reduce(ResponsePlan const& response, std::vector<double> const& times,
              std::vector<double> const& values)
{
    // Moments at which there was nothing to look at do not count.
    std::vector<double> t, v;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k])) {
            t.push_back(times[k]);
            v.push_back(values[k]);
        }
    if (v.empty())
        return not_given;
    auto const time_until = [&](auto const& passes) {
        auto const found = std::find_if(v.begin(), v.end(), passes);
        return found == v.end() ? not_given : t[static_cast<std::size_t>(found - v.begin())] - times.front();
    };
    switch (response.take) {
    case Take::final:
        return v.back();
    case Take::mean:
        return mean_of(v);
    case Take::sd:
        return sd_of(v);
    case Take::min:
        return *std::min_element(v.begin(), v.end());
    case Take::max:
        return *std::max_element(v.begin(), v.end());
    case Take::change:
        return v.back() - v.front();
    case Take::rate:
        return v.size() < 2 ? not_given : observe::fit_line(t, v).slope;
    case Take::time_above:
        return time_until([&](double value) { return value > response.threshold; });
    case Take::time_below:
        return time_until([&](double value) { return value < response.threshold; });
    }
    return not_given;
}

std::vector<Response> responses(Setup const& setup, std::vector<ResponseInfo> const& infos)
{
    std::vector<Response> all;
    for (auto const& response : setup.responses)
        all.push_back({infos[all.size()], response.stage,
                       std::isnan(response.threshold) ? "there was nothing to look at"
                                                      : "its threshold was not reached",
                       [&](Progress const& progress) {
                           return reduce(response, progress.column_in(response.stage, "time"),
                                         progress.column_in(response.stage, response.name));
                       }});
    return all;
}

} // namespace demens::rig::custom
