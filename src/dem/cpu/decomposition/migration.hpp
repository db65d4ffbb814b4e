#pragma once

#include "demens/dem/team.hpp"
#include "src/dem/cpu/decomposition/contact_parcels.hpp"

#include <span>
#include <vector>

namespace demens::dem {

//! Moves particles, and bodies with all of their elements, to new owners, and with them the histories of
//! their contacts.
class Migration
{
  public:
    //! \param numbers how the contact lists number particles: the ghosts are those of the last rebuild
    Migration(Team& team, State& state, ContactNumbers const& numbers);

    //! Sends the particles whose owner is another rank, and takes those of this one; there must be no ghosts,
    //! and elements of a body have one owner. Collective.
    void move(std::span<int const> owners);
    //! Gives the contacts of the lists the numbers that the particles have now that they were moved and the
    //! new ghosts appended, adds those that came, and drops those without a particle of this rank.
    void renumber();

  private:
    //! Of each rank, what goes there.
    struct Leaving
    {
        std::vector<std::vector<std::uint32_t>> particles, bodies;
    };
    Leaving leaving(std::span<int const> owners) const;

    Team& team_;
    State& state_;
    ContactNumbers before_;
    Renumbering numbers_;
    std::vector<Team::Bytes> contacts_, hull_contacts_; //!< that came, sender by sender
};

} // namespace demens::dem
