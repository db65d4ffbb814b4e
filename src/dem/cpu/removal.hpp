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

//! The new number of a particle that is none any more.
constexpr std::uint32_t gone = 0xffffffff;

//! Keeps those of a process, without its ghosts, of which `stays(number)` is true, in their order. \return
//! new numbers by the old ones
template <class Stays>
std::vector<std::uint32_t> keep_particles(Particles& particles, Stays const& stays)
{
    std::vector<std::uint32_t> new_number(particles.size(), gone);
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        if (!stays(k))
            continue;
        particles.place[next] = particles.place[k];
        particles.motion[next] = particles.motion[k];
        particles.load[next] = particles.load[k];
        particles.material[next] = particles.material[k];
        particles.id[next] = particles.id[k];
        new_number[k] = next++;
    }
    particles.resize(next);
    return new_number;
}

//! Takes spheres of a process, without its ghosts, out of the columns and of the lists, which keep the
//! contacts that touch, with their histories, and want to be made anew. \param ids of those that go \return
//! how many particles the lists know as owned now
std::size_t remove_particles(Particles& particles, ContactLists& contacts, ContactNumbers const& numbers,
                             std::unordered_set<std::uint32_t> const& ids);

} // namespace demens::dem
