#include "src/rig/custom/takes.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "demens/observe/surface.hpp"

#include <algorithm>
#include <cmath>

namespace demens::rig::custom {
namespace {

double mean(Course const& course)
{
    double mean = 0;
    for (double const value : course.values)
        mean += value / static_cast<double>(course.values.size());
    return mean;
}

double standard_deviation(Course const& course)
{
    double const middle = mean(course);
    double squares = 0;
    for (double const value : course.values)
        squares += (value - middle) * (value - middle) / static_cast<double>(course.values.size());
    return std::sqrt(squares);
}

//! When the threshold is passed, on the straight line between the moments before and after it.
template <class Passes>
double time_until(Course const& course, Passes const& passes)
{
    auto const found = std::find_if(course.values.begin(), course.values.end(), passes);
    if (found == course.values.end())
        return not_a_number;
    auto const k = static_cast<std::size_t>(found - course.values.begin());
    double const after = course.times[k] - course.begin;
    if (k == 0)
        return after;
    double const before = course.times[k - 1] - course.begin,
                 share =
                     (course.threshold - course.values[k - 1]) / (course.values[k] - course.values[k - 1]);
    return before + share * (after - before);
}

//! Slope between the moments at which a fifth and four fifths of the change are done: without start and tail.
double steady_rate(Course const& course)
{
    double const first = course.values.front(), change = course.values.back() - first;
    auto const done = [&](std::size_t k) { return (course.values[k] - first) / change; };
    std::size_t begin = 0, end = course.values.size();
    while (begin < end && !(done(begin) >= 0.2))
        ++begin;
    while (end > begin && !(done(end - 1) <= 0.8))
        --end;
    if (end - begin < 2)
        return not_a_number;
    auto const part = [&](std::vector<double> const& all) {
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                   all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    return observe::fit_line(part(course.times), part(course.values)).slope;
}

} // namespace

std::vector<Take> const& takes()
{
    using enum Take::Units;
    static std::vector<Take> const all = {
        {"final", [](Course const& c) { return c.values.back(); }},
        {"mean", mean},
        {"sd", standard_deviation},
        {"min", [](Course const& c) { return *std::min_element(c.values.begin(), c.values.end()); }},
        {"max", [](Course const& c) { return *std::max_element(c.values.begin(), c.values.end()); }},
        {"change", [](Course const& c) { return c.values.back() - c.values.front(); }},
        {"rate",
         [](Course const& c) {
             return c.values.size() < 2 ? not_a_number : observe::fit_line(c.times, c.values).slope;
         },
         rate},
        {"steady_rate", steady_rate, rate},
        {"time_above",
         [](Course const& c) { return time_until(c, [&](double value) { return value > c.threshold; }); },
         time},
        {"time_below",
         [](Course const& c) { return time_until(c, [&](double value) { return value < c.threshold; }); },
         time}};
    return all;
}

Take const& take_named(std::string const& name)
{
    for (auto const& take : takes())
        if (take.name == name)
            return take;
    throw InputError("\"" + name + "\" is nothing that can be made of a course");
}

std::string Take::units_for(std::string const& quantity) const
{
    switch (units) {
    case Units::of_quantity:
        return quantity;
    case Units::rate:
        return quantity == "1" ? "1/s" : quantity + "/s";
    case Units::time:
        return "s";
    }
    return quantity;
}

} // namespace demens::rig::custom
