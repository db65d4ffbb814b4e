#pragma once

#include "demens/grain/contact/core_gap.hpp"
#include "demens/grain/contact/face_pair.hpp"

namespace demens::grain {

//! Where two rounded hulls touch, each a core and its rounding [m], in the axes and from the place of the
//! first. \param set is overwritten; kept from pair to pair it costs nothing to make
//!
//! The distance of the cores says whether they do, and its normal which faces face each other. Each corner of
//! such a face that is nearer to the other than the roundings is a contact, and so are each two edges of them
//! whose nearest points lie within both, each along its own distance; what is counted twice is taken away
//! (`FacePair`). The deepest contact has the cores' distance and normal. Cores that overlap have one contact,
//! along the last normal.
//!
//! \param candidates kept from step to step for as long as the two have moved by no more than `margin` [m]
//! together since they were new; the result does not depend on them
DEMENS_FUNCTION inline void hull_contacts(CorePair const& pair, double rounding_a, double rounding_b,
                                          PairMemory& memory, ContactSet& set, FaceCandidates& candidates,
                                          double margin)
{
    using namespace detail;
    double const reach = rounding_a + rounding_b;
    CoreGap const nearest = core_gap(pair, reach, memory);
    set.count = 0;
    set.state = nearest.state;
    if (nearest.state == CoreState::apart || nearest.gap >= reach)
        return;
    Vector3 const &n = nearest.normal, n_in_b = pair.images.inverse(n);
    int const face_a = facing_face(pair.a, nearest.vertex_a, nearest.size, n, candidates.face_a);
    int const face_b = facing_face(pair.b, nearest.vertex_b, nearest.size, -n_in_b, candidates.face_b);
    if (nearest.state == CoreState::near && face_a >= 0 && face_b >= 0) {
        SeenFace a, b;
        a.see_a(pair, face_a);
        b.see_b(pair, face_b);
        if (!candidates.is_of(face_a, face_b)) {
            candidates.find(a, b, reach, margin);
            candidates.face_a = face_a, candidates.face_b = face_b;
        }
        FacePair(set, rounding_a, rounding_b).find(a, b, candidates);
    }
    if (set.count == 0)
        set.add({0.5 * (nearest.on_a + nearest.on_b + (rounding_a - rounding_b) * n), n, reach - nearest.gap,
                 1, only_place});
}

//! The same without candidates that are kept.
DEMENS_FUNCTION inline void hull_contacts(CorePair const& pair, double rounding_a, double rounding_b,
                                          PairMemory& memory, ContactSet& set)
{
    FaceCandidates candidates;
    hull_contacts(pair, rounding_a, rounding_b, memory, set, candidates, 0);
}

//! Places from the axes and the place of the first hull to those of space.
DEMENS_FUNCTION inline void put_in_space(ContactSet& set, CorePose const& first)
{
    for (int k = 0; k < set.count; ++k) {
        FeatureContact& contact = set.contacts[k];
        contact.point = first.place + first.rotation(contact.point);
        contact.normal = first.rotation(contact.normal);
    }
}

} // namespace demens::grain
