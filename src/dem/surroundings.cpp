#include "demens/dem/surroundings.hpp"

#include <cmath>
#include <numbers>

namespace demens::dem {

double Surroundings::drag_per_speed(double diameter, double speed) const
{
    constexpr double pi = std::numbers::pi, newton_from = 1000;
    double const stokes = 3 * pi * viscosity * diameter, inertia = density * diameter * speed;
    if (inertia >= newton_from * viscosity)
        return 0.44 * pi / 8 * inertia * diameter;
    return stokes * (1 + 0.15 * std::pow(inertia / viscosity, 0.687));
}

Vector3 Surroundings::acceleration(double time) const
{
    return std::sin(2 * std::numbers::pi * frequency * time) * vibration;
}

} // namespace demens::dem
