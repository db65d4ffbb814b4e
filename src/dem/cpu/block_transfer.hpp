#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_block.hpp"
#include "src/dem/cpu/contact_list.hpp"

namespace demens::dem {

// Between the records of bodies and histories and the lanes of a block. `block.slot` and `block.count` say
// which contacts.

//! Reads the bodies and histories of contacts among particles.
void gather_pairs(ContactBlock& block, ContactList const& list, Particles const& particles,
                  Periods const& periods);
//! The same for contacts with walls.
void gather_wall_contacts(ContactBlock& block, ContactList const& list, Particles const& particles,
                          std::vector<Wall> const& walls);
//! Writes the histories and adds the loads of contacts among particles, in the order of their slots.
void scatter_pairs(ContactBlock const& block, ContactList& list, Particles& particles);
//! The same for contacts with walls.
void scatter_wall_contacts(ContactBlock const& block, ContactList& list, Particles& particles,
                           std::vector<Wall> const& walls, std::vector<WallLoad>& wall_loads);

} // namespace demens::dem
