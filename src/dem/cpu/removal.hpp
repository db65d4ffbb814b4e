#pragma once

#include "demens/dem/particles.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/cpu/hulls/hull_contact_list.hpp"
#include "src/dem/cpu/rigid_bodies.hpp"

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
        if (!particles.body.empty())
            particles.body[next] = particles.body[k];
        if (!particles.hull.empty())
            particles.hull[next] = particles.hull[k];
        new_number[k] = next++;
    }
    particles.resize(next);
    if (!particles.body.empty())
        particles.body.resize(next);
    if (!particles.hull.empty())
        particles.hull.resize(next);
    return new_number;
}

//! What has become of the particles of a process.
struct Renumbered
{
    std::vector<std::uint32_t> new_number; //!< by the old ones; `gone` of those that are taken out
    std::size_t owned;                     //!< how many of them contact lists know as owned now
};

//! Takes particles of a process, without its ghosts, out of the columns and of the lists, which keep the
//! contacts that touch, with their histories, and want to be made anew. \param ids of those that go, of
//! bodies of all their elements
Renumbered remove_particles(Particles& particles, ContactLists& contacts, ContactNumbers const& numbers,
                            std::unordered_set<std::uint32_t> const& ids);

//! The bodies and the contacts of hulls after that: those of elements that are gone are taken out, and the
//! columns are those of spheres alone where no body is left.
void remove_bodies(Particles& particles, RigidBodies& bodies, HullContactLists& hulls,
                   std::span<std::uint32_t const> new_numbers);

} // namespace demens::dem
