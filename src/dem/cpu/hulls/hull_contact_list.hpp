#pragma once

#include "demens/grain/contact/core_gap.hpp"
#include "demens/grain/contact/face_candidates.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem {

//! A hull and what it may touch before the next rebuild.
struct HullPair
{
    std::uint32_t first, second; //!< particles, the first one a hull; or a hull and a wall
    grain::PairMemory memory = {};
};

//! What spares the search of contacts of a pair while the two move little. Nothing depends on it: it is not
//! in records, and found again where it is lost.
struct HullPairHints
{
    grain::PairMemory apart = {}; //!< of a pair that does not touch
    grain::FaceCandidates faces = {};
    double faces_until =
        0; //!< how far the two may have moved together, see HullLoop, while `faces` holds [m]
};

//! One place where a pair touches, as a contact of two balls that stand for the bodies there: each has the
//! radius of its body (of a hull that of the sphere of the same volume) and moves with it, so that laws read
//! it as any other contact. A wall needs no ball.
struct HullContact
{
    std::uint32_t pair;    //!< its place among the pairs
    std::uint32_t feature; //!< what touches, see grain::feature_id; by it the history is found again
    double share;          //!< what forces are multiplied by
    Vector3 apart;      //!< from the second ball's centre, or the place on the wall, to the first one's [m]
    Vector3 arm_first;  //!< from the centre of the first body to that of its ball [m]
    Vector3 arm_second; //!< the same of the second body; zero of a wall
};

//! Contacts of hulls with other hulls and balls, or with walls, of the same materials, hence laws. Beside the
//! pairs, which are found at each rebuild, the contacts change with every step: a pair has any number of
//! them.
struct HullContactList
{
    std::uint32_t interaction = 0; //!< index of the law set
    ContactKind kind = ContactKind::pair;
    int state_size = 0;            //!< doubles of history per contact
    std::vector<HullPair> pairs{}; //!< in ascending order of both numbers

    std::vector<HullContact> contacts{}; //!< in the order of their pairs
    std::vector<double> state{};         //!< contacts x state_size

    //! How far the two of a pair may have moved together before they can touch [m]; empty: not known yet.
    std::vector<double> apart_until{};
    std::vector<HullPairHints> hints{}; //!< of pairs, with the former

    bool with_walls() const { return kind == ContactKind::wall; }
    double* history(std::size_t contact)
    {
        return state.data() + contact * static_cast<std::size_t>(state_size);
    }
    double const* history(std::size_t contact) const
    {
        return state.data() + contact * static_cast<std::size_t>(state_size);
    }
    void clear() { pairs.clear(), contacts.clear(), state.clear(), apart_until.clear(), hints.clear(); }
    //! How many pairs touch.
    std::size_t touching() const;

    //! One without pairs, of the same kind.
    HullContactList emptied() const
    {
        return {.interaction = interaction, .kind = kind, .state_size = state_size};
    }
    //! Calls `visit(pair, contacts)` for each pair and the places of its contacts.
    template <class Visit>
    void for_each_pair(Visit&& visit) const
    {
        std::size_t from = 0;
        for (std::uint32_t p = 0; p < pairs.size(); ++p) {
            std::size_t to = from;
            while (to < contacts.size() && contacts[to].pair == p)
                ++to;
            visit(pairs[p], Slots{from, to});
            from = to;
        }
    }
    //! Adds a pair with contacts of another list.
    void add(HullPair const& pair, HullContactList const& other, Slots const& of_other)
    {
        pairs.push_back(pair);
        add_contacts(static_cast<std::uint32_t>(pairs.size()) - 1, other, of_other);
    }
    //! Adds contacts to a pair after which none has contacts.
    void add_contacts(std::uint32_t pair, HullContactList const& other, Slots const& of_other)
    {
        for (std::size_t c = of_other.from; c < of_other.to; ++c) {
            contacts.push_back(other.contacts[c]);
            contacts.back().pair = pair;
            state.insert(state.end(), other.history(c), other.history(c) + other.state_size);
        }
    }
};

//! All of them: of each kind a list for each law set, by its number.
struct HullContactLists
{
    std::vector<HullContactList> pairs = {}, walls = {};
    std::vector<HullContactList> ghosts = {}; //!< none where one process has all particles

    std::vector<HullContactList>& of(ContactKind kind)
    {
        return kind == ContactKind::pair ? pairs : kind == ContactKind::wall ? walls : ghosts;
    }

    template <class Visit>
    void for_each(Visit&& visit)
    {
        for (auto* lists : {&pairs, &walls, &ghosts})
            for (HullContactList& list : *lists)
                visit(list);
    }
    template <class Visit>
    void for_each(Visit&& visit) const
    {
        for (auto const* lists : {&pairs, &walls, &ghosts})
            for (HullContactList const& list : *lists)
                visit(list);
    }
    //! Adds empty lists of the next law set.
    void add_law_set(int state_size, bool with_ghosts)
    {
        auto const number = static_cast<std::uint32_t>(pairs.size());
        for (ContactKind const kind : {ContactKind::pair, ContactKind::wall, ContactKind::ghost})
            if (kind != ContactKind::ghost || with_ghosts)
                of(kind).push_back({.interaction = number, .kind = kind, .state_size = state_size});
    }
};

} // namespace demens::dem
