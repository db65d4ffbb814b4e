#pragma once

#include "demens/dem/team.hpp"
#include "src/dem/cpu/decomposition/renumbering.hpp"

#include <optional>
#include <span>
#include <vector>

namespace demens::dem {

// Contacts that move with their particles. A pair at a border is known to the owners of both; whoever owns
// one of the two afterwards knows it then. Of balls: those that touch, with their histories; of hulls: all
// pairs.

//! Where each particle of this rank goes.
struct Moves
{
    int here;
    std::span<int const> owners;
    std::span<std::uint32_t const> ids;
    ContactNumbers const& numbers; //!< of the lists

    //! Of a particle of the lists; a ghost goes nowhere.
    int of(std::uint32_t particle) const { return particle < numbers.owned ? owners[particle] : here; }
    std::uint32_t id(std::uint32_t particle) const
    {
        return particle < numbers.owned ? ids[particle] : numbers.ghost_ids[particle - numbers.owned];
    }
    //! Calls `send(rank)` for the other ranks that one of these two goes to.
    template <class Send>
    void for_each(std::uint32_t i, std::uint32_t j, bool with_wall, Send&& send) const
    {
        int const to_i = of(i), to_j = with_wall ? here : of(j);
        if (to_i != here)
            send(to_i);
        if (to_j != here && to_j != to_i)
            send(to_j);
    }
};

//! What a contact that came is between, by its new numbers; of a wall, `second` is its number. None where it
//! is known here: both owners of a pair at a border may have sent it, with the same history, or it was here
//! all along.
std::optional<CandidatePair> new_ends(CandidatePair const& ids, bool with_wall, Renumbering const& numbers,
                                      KnownPairs& known);

//! Appends, for each rank, what goes there.
void write_contacts(std::vector<Team::Bytes>& parcels, ContactLists const& lists, Moves const& moves);
void write_contacts(std::vector<Team::Bytes>& parcels, HullContactLists const& lists, Moves const& moves);

//! After the particles have moved and the new ghosts are there: contacts without a particle of this rank are
//! dropped, the others get the new numbers.
void renumber_contacts(ContactLists& lists, Particles const& particles, Renumbering const& numbers,
                       KnownPairs& known);
void renumber_contacts(HullContactLists& lists, Particles const& particles, Renumbering const& numbers,
                       KnownPairs& known);
//! Adds what came and is not known.
void take_contacts(Team::Bytes const& parcel, ContactLists& lists, Renumbering const& numbers,
                   KnownPairs& known);
void take_contacts(Team::Bytes const& parcel, HullContactLists& lists, Renumbering const& numbers,
                   KnownPairs& known);

} // namespace demens::dem
