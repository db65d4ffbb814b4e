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
DEMENS_FUNCTION inline void hull_contacts(CorePair const& pair, double rounding_a, double rounding_b,
                                          PairMemory& memory, ContactSet& set)
{
    using namespace detail;
    double const reach = rounding_a + rounding_b;
    CoreGap const nearest = core_gap(pair, reach, memory);
    set.count = 0;
    set.state = nearest.state;
    if (nearest.state == CoreState::apart || nearest.gap >= reach)
        return;
    Vector3 const &n = nearest.normal, n_in_b = pair.images.inverse(n);
    int const face_a = facing_face(pair.a, nearest.vertex_a, nearest.size, n);
    int const face_b = facing_face(pair.b, nearest.vertex_b, nearest.size, -n_in_b);
    if (nearest.state == CoreState::near && face_a >= 0 && face_b >= 0) {
        SeenFace a, b;
        ContactAxes const axes(n);
        a.see(pair.a, pair.a.faces[face_a], pair.scale_a * axes.u, pair.scale_a * axes.w, pair.scale_a * n,
              {});
        a.normal = a.normal / pair.scale_a;
        b.see(pair.b, pair.b.faces[face_b], pair.images.inverse(axes.u), pair.images.inverse(axes.w), n_in_b,
              {dot(pair.shift, axes.u), dot(pair.shift, axes.w), dot(pair.shift, n)});
        b.normal = b.normal / pair.scale_b;
        FacePair(set, axes, rounding_a, rounding_b).find(a, b, dot(nearest.on_a, n), dot(nearest.on_b, n));
    }
    if (set.count == 0)
        set.add({0.5 * (nearest.on_a + nearest.on_b + (rounding_a - rounding_b) * n), n, reach - nearest.gap,
                 1, feature_id(ContactFeature::edges, nearest.vertex_a[0], nearest.vertex_b[0])});
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
