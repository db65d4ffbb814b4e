#pragma once

#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <cstdint>
#include <utility>

namespace demens::dem {

//! Compacts the slots of contacts that touch or are within the laws' range, and of those that were in the
//! step before and no longer are. Returns both counts.
std::pair<std::size_t, std::size_t> test_pairs(ContactList& list, Slots slots, Particles const& particles,
                                               Periods const& periods, contact::Range const& range,
                                               std::uint32_t* now, std::uint32_t* parted);

} // namespace demens::dem
