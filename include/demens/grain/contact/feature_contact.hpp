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
    edges = 2,
    vertices = 3, //!< the rest: what is taken away where others count twice
    vertex_of_a_on_edge = 4,
    vertex_of_b_on_edge = 5
};
DEMENS_INLINE DEMENS_FUNCTION std::uint32_t feature_id(ContactFeature kind, std::uint32_t a, std::uint32_t b)
{
    return static_cast<std::uint32_t>(kind) << 24 | a << 12 | b;
}
//! A pair's only place, wherever it is: it goes on from feature to feature with its history. Which corners of
//! a face the search ends with is chance.
constexpr std::uint32_t only_place = static_cast<std::uint32_t>(ContactFeature::edges) << 24 | 0xffffff;
constexpr std::uint32_t features_of_second = 1U << 12; //!< how many numbers those of the second have

//! One place where two rounded hulls touch, or one and a wall.
struct FeatureContact
{
    Vector3 point;  //!< middle of the overlap [m]
    Vector3 normal; //!< unit, from the first to the second
    double overlap; //!< along the normal [m]
    double share;   //!< what its force is multiplied by: 1, less or below 0 where others touch there too
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
    static constexpr int most = 48; //!< of more those that count least are left out
    CoreState state = CoreState::apart;
    int count = 0;
    FeatureContact contacts[most];

    //! Adds one, unless it is without an overlap or there are heavier ones enough.
    DEMENS_FUNCTION void add(FeatureContact const& contact)
    {
        if (!(contact.overlap > 0))
            return;
        if (count < most) {
            contacts[count++] = contact;
            return;
        }
        auto const weight = [](FeatureContact const& c) {
            return c.overlap * (c.share < 0 ? -c.share : c.share);
        };
        int lightest = 0;
        for (int k = 1; k < most; ++k)
            if (weight(contacts[k]) < weight(contacts[lightest]))
                lightest = k;
        if (weight(contacts[lightest]) < weight(contact))
            contacts[lightest] = contact;
    }
};

} // namespace demens::grain
