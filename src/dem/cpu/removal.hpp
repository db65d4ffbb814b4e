#pragma once

#include "demens/dem/particles.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <span>
#include <unordered_set>

namespace demens::dem {

//! How contact lists number the particles of a process: its own below `owned`, then ghosts, whose ids these
//! are.
struct ContactNumbers
{
    std::size_t owned;
    std::span<std::uint32_t const> ghost_ids;
};

//! Takes spheres of a process, without its ghosts, out of the columns and of the lists, which keep the
//! contacts that touch, with their histories, and want to be made anew. \param ids of those that go \return
//! how many particles the lists know as owned now
std::size_t remove_particles(Particles& particles, ContactLists& contacts, ContactNumbers const& numbers,
                             std::unordered_set<std::uint32_t> const& ids);

} // namespace demens::dem
