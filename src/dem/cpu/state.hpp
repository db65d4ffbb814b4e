#pragma once

#include "demens/contact/evaluation/state_layout.hpp"
#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/cpu/energy_tally.hpp"
#include "src/dem/cpu/hulls/hull_contact_list.hpp"
#include "src/dem/cpu/neighbours.hpp"
#include "src/dem/cpu/rigid_bodies.hpp"
#include "src/dem/wall_set.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem {

//! When the neighbour lists are due.
struct ListClock
{
    bool is_stale = true;
    double travelled = 0;  //!< bound on how far any body moved since the rebuild [m]
    double near_until = 0; //!< distance travelled after which contacts are renewed [m]
    NeighbourReach reach = {};
    double smallest_radius = 0;              //!< of the particles of this process, or less [m]
    std::vector<contact::Range> ranges = {}; //!< of each law set, for the largest particle
    std::int64_t rebuilds = 0;
};

//! All that a simulation is at one moment: one for each replica.
struct State
{
    Particles particles = {}; //!< of this process
    RigidBodies bodies = {};  //!< whose elements are particles
    WallSet walls = {};
    std::vector<WallLoad> wall_loads = {}; //!< by the particles of this process
    ContactLists contacts = {};            //!< of balls
    HullContactLists hulls = {};           //!< contacts of which one side, or both, are hulls
    EnergyTally tally = {};                //!< zero without the ledger
    ListClock lists = {};
    std::uint32_t particles_added = 0;   //!< by all processes
    std::uint32_t particles_removed = 0; //!< of all processes
    std::int64_t steps_done = 0;
    bool left_domain = false;
    bool leaping = false;     //!< a particle has moved by more than its radius in a step since the last check
    bool overlapping = false; //!< an overlap was beyond the limit since the last check
};

//! How many ids the grains of this process have: of a hull each ball that it is read as has one.
inline std::size_t ids_here(State const& state)
{
    return state.particles.owned() - state.bodies.element.size() + state.bodies.all_ids();
}

//! Adds empty lists of contacts for the next law set.
inline void add_law_set(State& state, contact::StateLayout const& layout, bool with_ghosts)
{
    state.contacts.add_law_set(layout.size, layout.scalars, with_ghosts);
    state.hulls.add_law_set(layout.size, with_ghosts);
}

} // namespace demens::dem
