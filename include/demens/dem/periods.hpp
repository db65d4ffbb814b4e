#pragma once

#include "demens/dem/particles.hpp"

#include <cmath>
#include <limits>

namespace demens::dem {

//! A direction in which everything repeats itself; none where `upper` is not above `lower`.
struct Period
{
    double lower = 0, upper = 0; //!< [m]

    DEMENS_FUNCTION bool on() const { return upper > lower; }
    //! [m]; 0 where off.
    DEMENS_FUNCTION double length() const { return on() ? upper - lower : 0; }
    //! Half the length [m]; infinite where off.
    DEMENS_FUNCTION double half() const
    {
        return on() ? 0.5 * (upper - lower) : std::numeric_limits<double>::infinity();
    }
    //! The place within the period that is equal to a coordinate [m].
    DEMENS_FUNCTION double wrapped(double at) const
    {
        return on() && !(at >= lower && at < upper) ? at - length() * std::floor((at - lower) / length())
                                                    : at;
    }
};

//! The periodic directions. Particles meet their neighbours across the borders; walls are not repeated and
//! must reach beyond the borders by a particle.
struct Periods
{
    Period x = {}, y = {};

    DEMENS_FUNCTION bool any() const { return x.on() || y.on(); }
};

//! Difference of two places to the nearest image, in one direction.
DEMENS_INLINE DEMENS_FUNCTION double nearest_image(double difference, double length, double half)
{
    return difference - (difference > half ? length : 0.0) + (difference < -half ? length : 0.0);
}

//! Square of the distance of two particles, across the periods if there are any [m^2].
template <bool periodic>
DEMENS_INLINE DEMENS_FUNCTION double distance_squared(Place const& a, Place const& b, Periods const& periods)
{
    double dx = a.x - b.x, dy = a.y - b.y;
    double const dz = a.z - b.z;
    if constexpr (periodic) {
        dx = nearest_image(dx, periods.x.length(), periods.x.half());
        dy = nearest_image(dy, periods.y.length(), periods.y.half());
    }
    return dx * dx + dy * dy + dz * dz;
}

} // namespace demens::dem
