#include "demens/observe/circular_segment.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace demens::observe {
namespace {

constexpr double pi = std::numbers::pi;

//! The angle a for which (a - sin a cos a)/pi, which rises with a, is the area fraction.
double solve_half_angle(double area_fraction)
{
    double low = 0, high = pi;
    for (int k = 0; k < 60; ++k) {
        double const a = 0.5 * (low + high);
        (a - std::sin(a) * std::cos(a) < pi * area_fraction ? low : high) = a;
    }
    return 0.5 * (low + high);
}

} // namespace

CircularSegment::CircularSegment(double area_fraction) : half_angle(solve_half_angle(area_fraction))
{
    assert(area_fraction > 0 && area_fraction < 1);
    centre_distance = 2 * std::pow(std::sin(half_angle), 3) / (3 * pi * area_fraction);
}

double CircularSegment::energy(double angle_deg) const
{
    return 1 - centre_distance * std::cos(angle_deg * pi / 180);
}

double CircularSegment::angle_deg(double energy) const
{
    return std::acos((1 - energy) / centre_distance) * 180 / pi;
}

} // namespace demens::observe
