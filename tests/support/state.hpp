#pragma once

#include "demens/dem/simulation.hpp"

namespace demens::test {

//! All that can be read of the particles; as every view, valid until the simulation changes.
inline dem::StateView state_of(dem::Simulation& simulation)
{
    return simulation.read(dem::Fields::all);
}

struct Momenta
{
    Vector3 linear, angular; //!< [kg m/s], [kg m^2/s]
};

//! Of all particles, about a point.
inline Momenta momenta_of(dem::Simulation& simulation, Vector3 const& point)
{
    auto const now = state_of(simulation);
    Momenta sum;
    for (std::size_t k = 0; k < now.size(); ++k) {
        Vector3 const momentum = now.mass(k) * now.velocity(k);
        sum.linear += momentum;
        sum.angular += cross(now.position(k) - point, momentum) + now.inertia(k) * now.spin(k);
    }
    return sum;
}

} // namespace demens::test
