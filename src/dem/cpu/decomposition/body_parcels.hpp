#pragma once

#include "src/dem/cpu/decomposition/byte_stream.hpp"
#include "src/dem/cpu/decomposition/renumbering.hpp"

#include <span>

namespace demens::dem {

//! Appends some of the bodies, without their elements, as `append_bodies` reads them.
void write_bodies(ByteWriter& out, State const& state, std::span<std::uint32_t const> which);
//! Appends what was written; the elements are among the particles already and found by their ids.
void append_bodies(ByteReader& in, State& state, Renumbering const& numbers);

//! Appends what ghosts of these particles need beyond particles: which of them are hulls, and how.
void write_ghost_hulls(ByteWriter& out, State const& state, std::span<std::uint32_t const> which);
//! Reads it for the particles from a number on, which were appended last.
void read_ghost_hulls(ByteReader& in, State& state, std::size_t from);

} // namespace demens::dem
