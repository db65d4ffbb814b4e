#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/team.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace demens::dem {

//! Moves particles to new owners, and with them the histories of their touching contacts. A pair at a border
//! is known to the owners of both; whoever owns one of the two afterwards knows it then.
//!
//! In the contact lists, particles numbered from `owned` on are the ghosts of the last rebuild, by their ids.
class Migration
{
  public:
    Migration(Team& team, ContactLists& contacts, std::size_t owned,
              std::span<std::uint32_t const> ghost_ids);

    //! Sends the particles whose owner is another rank, and takes those of this one; there must be no ghosts.
    //! Collective.
    void move(Particles& particles, std::span<int const> owners);
    //! Gives the contacts of the lists the numbers that the particles have now that they were moved and the
    //! new ghosts appended, adds those that came, and drops those without a particle of this rank.
    void renumber(Particles const& particles);

  private:
    std::uint32_t id_of(Particles const& particles, std::uint32_t number) const;
    void write_contacts(Particles const& particles, std::span<int const> owners,
                        std::vector<Team::Bytes>& parcels) const;
    void compact(Particles& particles, std::span<int const> owners);
    //! New number of a body that may have come, or be a ghost.
    std::uint32_t find(std::uint32_t id) const;
    //! New number of a particle of the lists; `gone` if it is neither here nor a ghost.
    std::uint32_t number_of(std::uint32_t before) const;
    void take_arrived(Team::Bytes const& contacts, std::unordered_set<std::uint64_t>& known);

    Team& team_;
    ContactLists& lists_;
    std::size_t owned_;
    std::span<std::uint32_t const> ghost_ids_;
    std::vector<std::uint32_t> old_ids_, new_number_; //!< of the particles before; `gone` if another rank's
    std::size_t stayed_ = 0;
    std::vector<Team::Bytes> contacts_;                        //!< that came, sender by sender
    std::unordered_map<std::uint32_t, std::uint32_t> numbers_; //!< by id, of what came and of ghosts
};

} // namespace demens::dem
