#pragma once

#include "demens/grain/contact/core.hpp"
#include "demens/grain/contact/feature_contact.hpp"

namespace demens::grain {

//! Where a surface is, seen from a point.
struct SurfaceSide
{
    double distance; //!< to it; below 0 behind it [m]
    Vector3 normal;  //!< unit, from the point to its nearest place in front of it
};

//! Shares of vertices that are nearer to each other than `length` [m]: another counts as a part of a contact,
//! from all of it at the same place and with the same normal to nothing at that distance or at a right angle,
//! and no more than its overlap is deeper. So a hull that is nearly a ball, all of whose vertices touch,
//! touches as the ball does.
DEMENS_FUNCTION inline void share_places(ContactSet& set, double length)
{
    for (int i = 0; i < set.count; ++i) {
        FeatureContact& contact = set.contacts[i];
        double sum = 1;
        for (int j = 0; j < set.count; ++j) {
            FeatureContact const& other = set.contacts[j];
            double const y = norm_squared(contact.point - other.point) / (length * length);
            double const along = dot(contact.normal, other.normal);
            if (j == i || y >= 1 || along <= 0)
                continue;
            double const depth = other.overlap / contact.overlap;
            sum += along * (1 - y) * (1 - y) * (1 + 2 * y) * (depth < 1 ? depth : 1);
        }
        contact.share = 1 / sum;
    }
}

//! Where a rounded hull touches a surface that is flat or bends towards it (a plane, the inside of a cylinder
//! or cone): there its vertices are what is nearest. Each is a ball that touches on its own, in the axes of
//! space. \param surface SurfaceSide of a place \param rounding [m]
DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES
template <class Surface>
DEMENS_FUNCTION ContactSet wall_contacts(CoreView const& core, CorePose const& pose, double rounding,
                                         Surface&& surface)
{
    ContactSet set;
    for (std::uint16_t v = 0; v < core.vertex_count; ++v) {
        Vector3 const p = pose.place + pose.rotation(pose.scale * core.vertices[v]);
        SurfaceSide const side = surface(p);
        double const overlap = rounding - side.distance;
        if (overlap <= 0)
            continue;
        if (set.state != CoreState::overlapping)
            set.state = side.distance > 0 ? CoreState::near : CoreState::overlapping;
        set.add({p + 0.5 * (rounding + side.distance) * side.normal, side.normal, overlap, 1,
                 feature_id(ContactFeature::vertex_of_a, v, 0)});
    }
    if (set.count > 1)
        share_places(set, rounding);
    return set;
}

} // namespace demens::grain
