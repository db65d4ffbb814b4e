#pragma once

#include "src/dem/cuda/view.hpp"

namespace demens::dem::cuda {

//! Over particles of `from`: everything of a particle that lasts, into arrays with more room.
struct MoveParticle
{
    View from, to;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        std::uint64_t const i = from.first_of(where.slot) + where.local;
        std::uint64_t const j = to.first_of(where.slot) + where.local;
        to.load[j] = from.load[i];
        to.near_meshes[j] = from.near_meshes[i];
        if (from.room.has_ledger)
            to.tallies[j] = from.tallies[i];
        for (std::uint64_t set = 0; set < 2; ++set) {
            std::uint64_t const a = set * from.all + i, b = set * to.all + j;
            to.place[b] = from.place[a];
            to.motion[b] = from.motion[a];
            to.seen[b] = from.seen[a];
            to.material[b] = from.material[a];
            to.id[b] = from.id[a];
            to.neighbours[b] = from.neighbours[a];
            to.near_walls[b] = from.near_walls[a];
            to.touching_walls[b] = from.touching_walls[a];
        }
        // Of the lists those that hold; the others may be longer than their room.
        std::uint32_t const set = from.replica[where.slot].sorted;
        for (std::uint32_t word = 0; word < from.words(); ++word)
            to.touching[to.at(set, to.words(), word, j)] = from.touching[from.at(set, from.words(), word, i)];
        std::uint32_t const count = from.neighbours[set * from.all + i];
        for (std::uint32_t k = 0; k < count && k < from.room.neighbours; ++k) {
            to.neighbour_at(set, j, k) = from.neighbour_at(set, i, k);
            for (std::uint32_t n = 0; n < from.room.history; ++n)
                to.history_of(set, j, k)[n] = from.history_of(set, i, k)[n];
        }
        std::uint32_t const walls = from.near_walls[set * from.all + i] + from.replica[where.slot].mesh_slots;
        for (std::uint32_t k = 0; k < walls && k < from.room.walls; ++k) {
            to.near_wall[to.at(set, to.room.walls, k, j)] =
                from.near_wall[from.at(set, from.room.walls, k, i)];
            double const* const a = from.wall_history_of(set, i, k);
            double* const b = to.wall_history_of(set, j, k);
            for (std::uint32_t n = 0; n < from.room.history; ++n)
                b[n] = a[n];
            for (std::uint32_t n = 0; n < wall_numbers; ++n)
                b[to.room.history + n] = a[from.room.history + n];
        }
    }
};

} // namespace demens::dem::cuda
