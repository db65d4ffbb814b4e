#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem {

//! A triangle that a particle may touch before the next rebuild.
struct NearTriangle
{
    std::uint32_t triangle;
    float
        due; //!< the particle does not touch it before the bodies have travelled so far since the rebuild [m]
};

//! A particle near a mesh. It may touch several triangles, but the contacts are its own: they go on as it
//! moves from triangle to triangle.
struct MeshPatch
{
    static constexpr std::uint32_t few_contacts = 4; //!< that any patch has room for
    static constexpr float always = -1;

    std::uint32_t first_slot, slots;         //!< its places in the contact list
    std::uint32_t first_triangle, triangles; //!< its places among the near triangles
    float due; //!< that of the first triangle due; `always` while it touches any

    // While it touches, its own path counts instead of what the fastest body may have travelled.
    std::uint32_t soon = 0;   //!< so many of its near triangles, moved to the front, are due soon
    float later_due = always; //!< that of the first of the others
    double path = -1;         //!< of the particle along the mesh since the rebuild [m]; -1: not yet looked at
    Vector3 seen_at = {};     //!< where it was when it was looked at last, in the mesh's coordinates [m]
};

//! Slots [from, to) of a contact list.
struct Slots
{
    std::size_t from, to;
};

//! Two particles that may touch before the next rebuild.
struct CandidatePair
{
    std::uint32_t first, second;
};

//! What meets in a contact.
enum class ContactKind : std::uint8_t
{
    pair,  //!< two particles of this process
    wall,  //!< a particle and a wall
    ghost, //!< a particle of this process and one of another
};

//! Contacts of the same materials, hence laws, with their history.
//!
//! Pairs of particles are found in two stages: the candidates are all that may touch before the next rebuild;
//! the contacts are those of them that are near, in the same order, and are found anew more often. Histories
//! thus lie side by side. With walls every pair of the list is a contact.
struct ContactList
{
    std::uint32_t interaction = 0;        //!< index of the law set
    ContactKind kind = ContactKind::pair; //!< of a wall: `second` is a wall, not a particle
    int state_size = 0;                   //!< doubles of history per pair: scalars, then vectors
    int state_scalars = 0; //!< how many of them are scalars; vectors change sign when a pair is reversed

    std::vector<CandidatePair> candidates{}; //!< empty with walls

    std::vector<std::uint32_t> first{}, second{};
    std::vector<std::uint8_t> touching{}; //!< 1: touched in the last step, its history counts
    std::vector<double> state{};          //!< size() x state_size; zero where not touching
    std::vector<Vector3> offset{};        //!< walls: from the nearest point of the wall to the centre [m]

    std::vector<MeshPatch> patches{};           //!< walls that are meshes, in the order of their slots
    std::vector<NearTriangle> near_triangles{}; //!< of all patches
    bool wants_slots = false; //!< a patch has more contacts than slots: the list is to be made anew

    //! Walls that are no meshes: slots of one particle with several walls that may join, all of them
    //! together.
    std::vector<std::uint32_t> joined{};
    std::vector<std::uint32_t> joined_end{}; //!< where the slots of each particle end among them

    std::size_t size() const { return first.size(); }
    void clear()
    {
        candidates.clear();
        first.clear();
        second.clear();
        touching.clear();
        state.clear();
        offset.clear();
        patches.clear();
        near_triangles.clear();
        wants_slots = false;
        joined.clear();
        joined_end.clear();
    }
    //! Whether all columns have the length that they should.
    bool is_whole() const
    {
        std::size_t const count = size();
        return second.size() == count && touching.size() == count &&
               state.size() == count * static_cast<std::size_t>(state_size) &&
               offset.size() == (kind == ContactKind::wall ? count : 0);
    }
    //! Adds a pair without history.
    void add(std::uint32_t i, std::uint32_t j)
    {
        first.push_back(i);
        second.push_back(j);
        touching.push_back(0);
        state.resize(state.size() + static_cast<std::size_t>(state_size), 0.0);
        if (kind == ContactKind::wall)
            offset.push_back({});
    }
};

//! Part of the contacts of this kind that belongs to this process: those with ghosts are half the other's.
inline double share_of(ContactKind kind)
{
    return kind == ContactKind::ghost ? 0.5 : 1.0;
}

//! All contacts of a process: of each kind a list for each law set, by its number.
struct ContactLists
{
    std::vector<ContactList> pairs = {}, walls = {};
    std::vector<ContactList> ghosts = {}; //!< none where one process has all particles

    std::vector<ContactList>& of(ContactKind kind)
    {
        return kind == ContactKind::pair ? pairs : kind == ContactKind::wall ? walls : ghosts;
    }
    std::vector<ContactList> const& of(ContactKind kind) const
    {
        return const_cast<ContactLists&>(*this).of(kind);
    }
    //! In the order in which they are evaluated.
    template <class Visit>
    void for_each(Visit&& visit)
    {
        for (auto* lists : {&pairs, &walls, &ghosts})
            for (ContactList& list : *lists)
                visit(list);
    }
    template <class Visit>
    void for_each(Visit&& visit) const
    {
        for (auto const* lists : {&pairs, &walls, &ghosts})
            for (ContactList const& list : *lists)
                visit(list);
    }
    //! Adds empty lists of the next law set.
    void add_law_set(int state_size, int state_scalars, bool with_ghosts)
    {
        auto const number = static_cast<std::uint32_t>(pairs.size());
        for (ContactKind const kind : {ContactKind::pair, ContactKind::wall, ContactKind::ghost})
            if (kind != ContactKind::ghost || with_ghosts)
                of(kind).push_back({.interaction = number,
                                    .kind = kind,
                                    .state_size = state_size,
                                    .state_scalars = state_scalars});
    }
};

} // namespace demens::dem
