#pragma once

#include "demens/dem/state_view.hpp"

#include <algorithm>
#include <cmath>

namespace demens::dem {

// Of spheres that move by themselves; rigid bodies are not in it.

//! Of translation and rotation, at the time of the places; ghosts are not in it [J].
inline double kinetic_energy(Particles const& particles, CatchUp const& now)
{
    double energy = 0;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        if (!particles.is_alone(k))
            continue;
        Motion const& m = particles.motion[k];
        Load const& l = particles.load[k];
        energy +=
            0.5 * m.mass * norm_squared(now.velocity(m, l)) + 0.5 * m.inertia * norm_squared(now.spin(m, l));
    }
    return energy;
}

//! Of the fastest centre, at the time of the places; ghosts do not count [m/s].
inline double largest_speed(Particles const& particles, CatchUp const& now)
{
    double squared = 0;
    for (std::size_t k = 0; k < particles.owned(); ++k)
        if (particles.is_alone(k))
            squared = std::max(squared, norm_squared(now.velocity(particles.motion[k], particles.load[k])));
    return std::sqrt(squared);
}

} // namespace demens::dem
