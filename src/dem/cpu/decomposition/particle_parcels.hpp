#pragma once

#include "demens/dem/particles.hpp"
#include "src/dem/cpu/decomposition/byte_stream.hpp"

#include <span>

namespace demens::dem {

//! Whether loads travel with the particles: ghosts need none; who reads velocities at the time of the places
//! does, also after a move.
enum class Loads
{
    stay,
    travel
};

//! Appends some of the particles, as `append_particles` reads them.
void write_particles(ByteWriter& out, Particles const& particles, std::span<std::uint32_t const> which,
                     Loads loads);
//! Appends what was written; returns how many.
std::size_t append_particles(ByteReader& in, Particles& particles, Loads loads);

} // namespace demens::dem
