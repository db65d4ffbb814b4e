#pragma once

#include "demens/dem/energy.hpp"
#include "demens/dem/simulation_options.hpp"
#include "demens/dem/state_view.hpp"

namespace demens::dem {

// Of spheres that move by themselves; what rigid bodies have is not in it.

//! In gravity, from the origin [J]; ghosts are not in it.
inline double potential_energy(Particles const& particles, Vector3 const& gravity)
{
    double energy = 0;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        if (!particles.is_alone(k))
            continue;
        Place const& p = particles.place[k];
        energy -= particles.motion[k].mass * dot(gravity, Vector3{p.x, p.y, p.z});
    }
    return energy;
}

//! Adds what particles have now; ghosts are not in it. Velocities must be half a time step behind the places,
//! except where `now` brings them no further.
inline void add_particles(EnergyLedger& ledger, Particles const& particles, SimulationOptions const& options,
                          CatchUp const& now)
{
    double const half = 0.5 * options.time_step;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        if (!particles.is_alone(k))
            continue;
        // The velocities before and after the kick at this place are v - half a and v + half a.
        Motion const& m = particles.motion[k];
        Load const& l = particles.load[k];
        Vector3 const change = half * (Vector3{l.fx, l.fy, l.fz} / m.mass + options.gravity);
        Vector3 const turn = half / m.inertia * Vector3{l.tx, l.ty, l.tz};
        ledger.kinetic_translation +=
            0.5 * m.mass * (norm_squared(now.velocity(m, l)) - norm_squared(change));
        ledger.kinetic_rotation += 0.5 * m.inertia * (norm_squared(now.spin(m, l)) - norm_squared(turn));
    }
    ledger.potential += potential_energy(particles, options.gravity);
}

//! What a particle brings in that enters after the beginning, as the ledger sees it: the product of the
//! velocities before and after the kick at its place counts [J].
inline double energy_on_entry(Place const& p, Motion const& m, SimulationOptions const& options)
{
    Vector3 const before{m.vx, m.vy, m.vz};
    Vector3 const after = before + options.time_step * options.gravity;
    return m.mass * (0.5 * dot(before, after) - dot(options.gravity, Vector3{p.x, p.y, p.z})) +
           0.5 * m.inertia * norm_squared(Vector3{m.wx, m.wy, m.wz});
}

} // namespace demens::dem
