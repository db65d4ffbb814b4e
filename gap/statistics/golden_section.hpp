#pragma once

#include <numbers>

namespace demens::gap {

//! Where a function with one maximum between two numbers has it, within `tolerance`.
template <class Function>
double argmax_between(double lower, double upper, double tolerance, Function const& f)
{
    constexpr double share = std::numbers::phi - 1;
    double left = upper - share * (upper - lower), right = lower + share * (upper - lower);
    double at_left = f(left), at_right = f(right);
    while (upper - lower > tolerance)
        if (at_left > at_right) {
            upper = right;
            right = left;
            at_right = at_left;
            left = upper - share * (upper - lower);
            at_left = f(left);
        } else {
            lower = left;
            left = right;
            at_left = at_right;
            right = lower + share * (upper - lower);
            at_right = f(right);
        }
    return 0.5 * (lower + upper);
}

} // namespace demens::gap
