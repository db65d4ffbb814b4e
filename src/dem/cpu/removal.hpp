#pragma once

#include "src/dem/cpu/state.hpp"

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
        if (particles.has_bodies)
            particles.body[next] = particles.body[k];
        if (particles.has_hulls)
            particles.hull[next] = particles.hull[k];
        new_number[k] = next++;
    }
    particles.resize(next);
    return new_number;
}

//! Keeps the bodies whose elements stay; `new_numbers` as of `keep_particles`, which is done. Shapes stay.
void keep_bodies(RigidBodies& bodies, Particles& particles, std::span<std::uint32_t const> new_numbers);

//! Adds the other elements of bodies of this process whose first one is named. \return how many more ids
//! these have, of a hull those of the balls that it is read as
std::size_t name_elements(State const& state, std::unordered_set<std::uint32_t>& ids);

//! Takes particles of a process, without its ghosts, out of the columns and of the lists, and with them their
//! bodies; the lists keep the contacts that touch, with their histories, and want to be made anew. \param ids
//! of those that go, of bodies of all their elements \return how many particles lists know as owned now
std::size_t remove_particles(State& state, ContactNumbers const& numbers,
                             std::unordered_set<std::uint32_t> const& ids);

//! Where no body is left in any process: the columns are those of spheres alone.
void forget_bodies(State& state);

} // namespace demens::dem
