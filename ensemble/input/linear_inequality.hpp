#pragma once

#include <functional>
#include <string>
#include <vector>

namespace demens::ensemble::input {

//! sum_k coefficients[k] x_k <= bound
struct LinearInequality
{
    std::vector<double> coefficients;
    double bound = 0;
};

//! Reads e.g. `2*a - b <= 0.5` or `a >= b/3 + 1`: sums of numbers and of variables times or over a number, on
//! both sides of `<=` or `>=`. \throws InputError without a place \param variable_index place of a variable
//! among the `variables`; throws when there is none of that name
LinearInequality
parse_linear_inequality(std::string const& text, std::size_t variables,
                        std::function<std::size_t(std::string const&)> const& variable_index);

} // namespace demens::ensemble::input
