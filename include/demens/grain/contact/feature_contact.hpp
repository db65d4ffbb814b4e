#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>

namespace demens::grain {

//! Which features touch, so that what a contact has stored is found again in the next step: the kind and the
//! numbers of a vertex or edge of each. A vertex touches another hull in one place, whichever feature lies
//! there.
enum class ContactFeature : std::uint32_t
{
    vertex_of_a = 0, //!< on anything
    vertex_of_b = 1,
    edges = 2
};
DEMENS_INLINE DEMENS_FUNCTION std::uint32_t feature_id(ContactFeature kind, std::uint32_t a, std::uint32_t b)
{
    return static_cast<std::uint32_t>(kind) << 24 | a << 12 | b;
}

//! One place where two rounded hulls touch, or one and a wall.
struct FeatureContact
{
    Vector3 point;         //!< middle of the overlap [m]
    Vector3 normal;        //!< unit, from the first to the second
    double overlap;        //!< along the normal [m]
    double share;          //!< what its force is multiplied by; below 1 where others touch at the same place
    std::uint32_t feature; //!< see feature_id
};

//! How two cores lie, or one and a wall.
enum class CoreState : std::uint8_t
{
    apart,      //!< farther than asked for; nothing else is told
    near,       //!< within reach
    overlapping //!< the cores themselves: deeper than the roundings; the normal is the last known one
};

//! All contacts of a pair.
struct ContactSet
{
    static constexpr int most = 12; //!< of more the shallowest are left out
    CoreState state = CoreState::apart;
    int count = 0;
    FeatureContact contacts[most];

    //! Adds one, unless it is without an overlap or there are deeper ones enough.
    DEMENS_FUNCTION void add(FeatureContact const& contact)
    {
        if (!(contact.overlap > 0))
            return;
        if (count < most) {
            contacts[count++] = contact;
            return;
        }
        int shallowest = 0;
        for (int k = 1; k < most; ++k)
            if (contacts[k].overlap < contacts[shallowest].overlap)
                shallowest = k;
        if (contacts[shallowest].overlap < contact.overlap)
            contacts[shallowest] = contact;
    }

    //! Completes the shares, which are how much each contact counts by itself so far. Contacts at one place
    //! share a force: another within `length` [m] counts as a part of a contact, from all of it at the same
    //! place and with the same normal to nothing at that distance or at a right angle, and no more than its
    //! overlap is deeper. So a hull that is nearly a ball, all of whose corners touch, touches as the ball
    //! does. Together they count no less than the deepest alone. All of this has no jumps.
    DEMENS_FUNCTION void find_shares(double length)
    {
        double shares[most], deepest = 0, together = 0;
        for (int i = 0; i < count; ++i) {
            double sum = 1;
            for (int j = 0; j < count; ++j) {
                double const squared = norm_squared(contacts[i].point - contacts[j].point);
                double const along = dot(contacts[i].normal, contacts[j].normal);
                if (j == i || squared >= length * length || along <= 0)
                    continue;
                double const y = squared / (length * length), nearness = (1 - y) * (1 - y) * (1 + 2 * y);
                double const depth = contacts[j].overlap / contacts[i].overlap;
                sum += contacts[j].share * along * nearness * (depth < 1 ? depth : 1);
            }
            shares[i] = contacts[i].share / sum;
            together += shares[i] * contacts[i].overlap;
            deepest = contacts[i].overlap > deepest ? contacts[i].overlap : deepest;
        }
        double const lift = together > 0 && together < deepest ? deepest / together : 1;
        for (int i = 0; i < count; ++i)
            contacts[i].share = lift * shares[i];
    }
};

} // namespace demens::grain
