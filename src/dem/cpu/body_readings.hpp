#pragma once

#include "demens/dem/energy.hpp"
#include "src/dem/cpu/state.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

// What is read off rigid bodies; those of spheres alone: motion_readings.hpp, particle_energy.hpp.

//! How a body moves at the time of its place.
struct BodyNow
{
    Vector3 velocity, spin; //!< [m/s], [rad/s]
    double rotation_energy; //!< [J]
    BodyLoad load;          //!< of contacts and surroundings
};
BodyNow body_now(Params const& params, State const& state, std::size_t body);

double kinetic_energy_of_bodies(Params const& params, State const& state);   //!< [J]
double potential_energy_of_bodies(Params const& params, State const& state); //!< [J]
double largest_speed_of_bodies(Params const& params, State const& state);    //!< of a centre [m/s]
//! Adds what the bodies have, as `add_particles`.
void add_bodies(EnergyLedger& ledger, Params const& params, State const& state);
//! What the last body brings in that enters after the beginning [J].
double energy_on_entry_of_body(Params const& params, State const& state);

//! The particles with motions at the time of their places, as if none were half a step behind; in the place
//! of the sphere that holds a hull the balls of its outline.
Particles elements_now(Params const& params, State const& state);
//! A record for each grain: of spheres their own, of bodies that of their centre of mass, with the radius of
//! the sphere of the same volume, the id of the first element and the moment of inertia about the axis about
//! which they turn. Motions are those at the time of the places.
Particles grains_now(Params const& params, State const& state);

} // namespace demens::dem
