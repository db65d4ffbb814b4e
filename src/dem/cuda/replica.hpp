#pragma once

#include "demens/dem/periods.hpp"
#include "demens/dem/surroundings.hpp"
#include "src/dem/cuda/law_kernel.hpp"

#include <cstdint>

namespace demens::dem::cuda {

//! How it goes with a replica. One that does not run keeps its slot, and is left alone by all kernels.
enum class Status : std::uint32_t
{
    empty,        //!< a slot without a replica
    running,      //!< healthy
    not_a_number, //!< a place, velocity or spin is not finite
    escaped,      //!< a particle is outside the domain
    full,         //!< a list is longer than its room: it goes on when there is more
    crowded       //!< a particle is near more walls than there is room for
};

//! What the next launch does with a replica.
enum class Phase : std::uint32_t
{
    rest,
    move,          //!< kick and drift with the loads that are known
    load_and_move, //!< loads, then kick and drift with them: most launches
    load           //!< loads, kept for whoever reads them and for the next block of steps
};

//! One simulation of a batch, as the device has it. Particles are numbered in the replica; `slot * capacity`
//! more is where they lie.
struct Replica
{
    // What the host says.
    std::uint32_t particles, walls, materials;
    LawKernel kernel;     //!< that computes its steps
    double time_step;     //!< [s]
    Vector3 gravity;      //!< [m/s^2]
    double reach;         //!< of lists beyond contact [m]
    double trigger;       //!< square of the path after which lists are made anew [m^2]
    double wall_trigger;  //!< and the path of walls [m]
    double cell;          //!< least size of a cell [m]
    double overlap_limit; //!< over the smaller radius
    Vector3 lower, upper; //!< of the domain [m]
    Periods periods;
    Surroundings surroundings;
    std::uint32_t has_surroundings;
    std::int64_t steps_before;     //!< this block
    std::uint32_t wall_rows;       //!< 1: walls move, and have a row for each step of a block
    std::uint32_t mesh_slots;      //!< most contacts of a particle with meshes; 0: there are none
    std::uint32_t has_outer_loads; //!< see OuterKernel

    // What goes on.
    Status status;
    Phase phase;
    std::uint32_t current;     //!< which of the two sets of places and motions holds
    std::uint32_t sorted;      //!< which of the two sets of lists, and of what is sorted with them, holds
    std::uint32_t step, steps; //!< of this block: done, to do
    std::uint32_t first_kick_is_half;
    std::uint32_t stale; //!< lists are to be made anew, whatever has moved
    double walls_seen;   //!< path of the walls when lists were made [m]

    // What kernels find; any thread may raise one.
    std::uint32_t wants_lists, broken, outside, leaping, overlapping;
    std::uint32_t room_wanted, wall_room_wanted; //!< longest list that had no room
    std::uint32_t mesh_slots_wanted;             //!< more than there were for one particle

    // The grid of the last search.
    std::uint64_t low[3], high[3]; //!< of places, as ordered numbers
    Vector3 origin, per_length;    //!< [m], [1/m]
    std::int32_t nx, ny, nz;
    std::uint32_t rebuilds;
};

//! Steps of a simulation whose loads are being found; the ledger counts from those of step 0 on.
DEMENS_INLINE DEMENS_FUNCTION std::int64_t step_of(Replica const& r)
{
    return r.steps_before + r.step;
}

} // namespace demens::dem::cuda
