#pragma once

#include "demens/dem/particles.hpp"

namespace demens::dem {

//! Leapfrog form of velocity Verlet: velocities go on by `kick` [s], from the middle of one step to the
//! middle of the next, at first by half a step; then places by a time step. Uses the loads up: leaves zeros
//! to add the next ones to. Ghosts and elements of rigid bodies stay.
//! Returns the largest speed [m/s].
double move_particles(Particles& particles, double kick, double time_step, Vector3 const& gravity);

//! Whether one has moved by more than its radius in the last step: it may have passed through another body.
bool has_leapt(Particles const& particles, double time_step);

} // namespace demens::dem
