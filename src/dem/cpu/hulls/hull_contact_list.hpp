#pragma once

#include "demens/grain/contact/core_gap.hpp"
#include "demens/grain/contact/face_candidates.hpp"

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
    bool with_walls = false;
    int state_size = 0;            //!< doubles of history per contact
    std::vector<HullPair> pairs{}; //!< in ascending order of both numbers

    std::vector<HullContact> contacts{}; //!< in the order of their pairs
    std::vector<double> state{};         //!< contacts x state_size

    //! How far the two of a pair may have moved together before they can touch [m]; empty: not known yet.
    std::vector<double> apart_until{};
    std::vector<HullPairHints> hints{}; //!< of pairs, with the former

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
};

//! All of them: of each kind a list for each law set, by its number.
struct HullContactLists
{
    std::vector<HullContactList> pairs = {}, walls = {};

    template <class Visit>
    void for_each(Visit&& visit)
    {
        for (auto* lists : {&pairs, &walls})
            for (HullContactList& list : *lists)
                visit(list);
    }
    template <class Visit>
    void for_each(Visit&& visit) const
    {
        for (auto const* lists : {&pairs, &walls})
            for (HullContactList const& list : *lists)
                visit(list);
    }
    //! Adds empty lists of the next law set.
    void add_law_set(int state_size)
    {
        auto const number = static_cast<std::uint32_t>(pairs.size());
        pairs.push_back({.interaction = number, .with_walls = false, .state_size = state_size});
        walls.push_back({.interaction = number, .with_walls = true, .state_size = state_size});
    }
};

} // namespace demens::dem
