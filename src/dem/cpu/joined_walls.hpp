#pragma once

#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <vector>

namespace demens::dem {

//! From the shape's nearest point to p; where p lies on the shape, a short way along its normal.
template <class Shape>
DEMENS_INLINE Vector3 offset_from(Shape const& shape, Vector3 const& p, double radius)
{
    Vector3 const offset = p - nearest(shape, p);
    return norm_squared(offset) > 0 ? offset : 1e-9 * radius * normal(shape, p);
}

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
