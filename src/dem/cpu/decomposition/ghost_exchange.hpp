#pragma once

#include "src/dem/cpu/decomposition/bisection.hpp"
#include "src/dem/cpu/state.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace demens::dem {

//! Keeps copies of the particles that come near the boxes of other ranks where those are.
class GhostExchange
{
  public:
    //! Chooses the particles that may meet one of another rank, whose reach beyond their radius is at most
    //! `reach` [m], sends them, and appends those that come as ghosts. Collective.
    void rebuild(Team& team, Bisection const& boxes, State& state, double reach);
    //! After the particles were put into another order: the new number of each.
    void renumber(std::span<std::uint32_t const> new_number);

    //! Sends the places and motions of now, as far as they change.
    void begin(Team& team, State const& state);
    //! The ghosts are where their particles are.
    void finish(Team& team, State& state);

    //! Who sends what to whom, to be stored.
    struct Routes
    {
        std::vector<std::uint32_t> sent, received; //!< numbers of particles, rank by rank
        std::vector<std::int64_t> links;           //!< of each: rank, first and count of numbers out, and in
    };
    Routes routes() const;
    //! Takes them again. \throws InputError where they do not fit the team or the particles.
    void restore(Routes const& routes, Team const& team, std::size_t particles, bool has_hulls);

  private:
    //! Numbers of a particle that change: place, velocity, spin, and, where there are hulls, how it is
    //! turned.
    static std::size_t record(bool has_hulls) { return has_hulls ? 13 : 9; }
    void resize_buffers(bool has_hulls);

    std::vector<std::uint32_t> sent_, received_; //!< numbers of particles, rank by rank
    std::vector<Team::Link> links_;
    std::vector<double> out_, in_;
};

} // namespace demens::dem
