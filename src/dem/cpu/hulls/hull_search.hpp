#pragma once

#include "src/dem/cpu/hulls/hull_contact_list.hpp"
#include "src/dem/cpu/neighbours.hpp"
#include "src/dem/cpu/rigid_bodies.hpp"

namespace demens::dem {

//! Lists what hulls may touch, from what a neighbour search has found, and carries over memories and
//! histories.
class HullSearch
{
  public:
    //! Law set of each pair of materials, as for NeighbourSearch.
    HullSearch(std::size_t materials, std::vector<std::uint32_t> interaction)
        : materials_(materials), interaction_(std::move(interaction))
    {
    }

    //! After a rebuild by `search`; the particles have their new numbers.
    void rebuild(NeighbourSearch const& search, Particles const& particles, std::vector<Wall> const& walls,
                 HullContactLists& lists);

  private:
    std::size_t materials_;
    std::vector<std::uint32_t> interaction_;
};

} // namespace demens::dem
