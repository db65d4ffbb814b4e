#include "src/dem/surrounding_forces.hpp"

namespace demens::dem {

double Surroundings::drag_per_speed(double diameter, double speed) const
{
    return drag_per_speed_in(*this, diameter, speed);
}

Vector3 Surroundings::acceleration(double time) const
{
    return acceleration_in(*this, time);
}

} // namespace demens::dem
