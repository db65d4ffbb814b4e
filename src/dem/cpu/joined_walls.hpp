#pragma once

#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/wall_offset.hpp"

#include <vector>

namespace demens::dem {

//! Notes which slots of a list of wall contacts are of one particle with walls that it may feel in one place:
//! flat ones side by side, the sides of a box from outside, a rim. Meshes join their triangles themselves.
void find_joined(ContactList& list, std::vector<Place> const& places, std::vector<Wall> const& walls);

//! The offset of a slot of a particle with walls that join [m].
struct JoinedContact
{
    std::uint32_t slot;
    Vector3 offset;
};

//! Finds where particles touch walls that join, by the rule of MeshContactFinder: the deepest place counts,
//! and others so far as they rise above the planes of the deeper ones. Where a contact goes on from one wall
//! to the next it takes its history along. In the order of the slots.
std::vector<JoinedContact> join_contacts(ContactList& list, std::vector<Place> const& places,
                                         std::vector<Wall> const& walls, contact::Range const& range);

} // namespace demens::dem
