#pragma once

#include "demens/contact/range.hpp"
#include "demens/dem/contact_list.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/wall.hpp"

#include <utility>
#include <vector>

namespace demens::dem {

//! Particles that are nearer to the wall than their radius plus `reach` [m], in ascending order.
std::vector<std::uint32_t> particles_near(Wall const& wall, Particles const& particles, double reach);

//! Finds where the particles of a list of wall contacts touch, and stores the offsets. Compacts the slots
//! that touch or are within the laws' range, and those that touched before and no longer do, as the test of
//! pairs does. Returns both counts.
std::pair<std::size_t, std::size_t> test_wall_contacts(ContactList& list, Particles const& particles,
                                                       std::vector<Wall> const& walls,
                                                       contact::Range const& range, std::uint32_t* now,
                                                       std::uint32_t* parted);

} // namespace demens::dem
