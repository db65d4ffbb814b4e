#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/record_fields.hpp"
#include "src/dem/cuda/tally.hpp"
#include "src/dem/params.hpp"
#include "src/dem/wall_set.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem::cuda {

//! The whole state of a slot of a batch between blocks of steps, wherever in the batch it is.
struct SlotState
{
    Particles particles; //!< of the device, in its order
    Particles waiting;   //!< added, and not on the device yet
    std::vector<Place> seen;

    // Lists: of each particle, one after another
    std::vector<std::uint32_t> neighbours, neighbour; //!< how many; which
    std::vector<std::uint8_t> touching;               //!< of each neighbour: 1 or 0
    std::vector<double> history;                      //!< of those that touch, so many numbers each:
    std::uint32_t history_size = 0;
    std::vector<std::uint32_t> near_walls, near_wall; //!< how many, meshes apart; which, with those behind
    std::vector<std::uint8_t> touching_walls;         //!< of each: 1 or 0
    std::vector<double> wall_history;                 //!< of those that touch, `wall_numbers` behind each
    std::vector<std::uint32_t> near_meshes;

    // Clocks, and what was found
    std::uint32_t status = 0, rebuilds = 0, mesh_slots = 0, mesh_slots_wanted = 0;
    bool leaping = false, overlapping = false, loads_are_known = false, stale = true;
    double walls_seen = 0, wall_path = 0; //!< [m]
    std::int64_t steps_done = 0;
    std::vector<double> gaps;   //!< of the laws, for the largest particle [m]
    std::vector<Tally> tallies; //!< with the ledger
    double brought_in = 0, turned_over = 0;
    WallSet walls;

    std::size_t added() const { return particles.size() + waiting.size(); }

    void write(StateRecord& record) const;
    //! \throws InputError where the record does not make a state with these parameters.
    static SlotState read(StateRecord const& record, Params const& params);
    //! Whether a record is of a slot, not of another engine.
    static bool is_in(StateRecord const& record);

  private:
    template <class Record>
    void visit_all(Record& record);
    void check(Params const& params) const;
};

} // namespace demens::dem::cuda
