#include "ensemble/input/option_range.hpp"

#include <climits>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::ensemble::input {

std::string range_text(OptionSpec const& spec)
{
    constexpr double smallest_positive = std::numeric_limits<double>::min();
    std::string range;
    if (spec.lower == smallest_positive)
        range = "greater than 0";
    else if (std::isfinite(spec.lower))
        range = fmt::format("at least {}", spec.lower);
    if (std::isfinite(spec.upper) && spec.upper < INT_MAX)
        range += fmt::format("{}at most {}", range.empty() ? "" : " and ", spec.upper);
    return range;
}

std::string range_complaint(OptionSpec const& spec, double value)
{
    if (!std::isfinite(value))
        return "must be a finite number";
    if (value >= spec.lower && value <= spec.upper)
        return {};
    return value > spec.upper && spec.upper >= INT_MAX ? fmt::format("must be at most {}", spec.upper)
                                                       : "must be " + range_text(spec);
}

} // namespace demens::ensemble::input
