#pragma once

#include "demens/base/vector3.hpp"

#include <array>
#include <cstdint>

namespace demens::shape {

//! Where on a triangle its point nearest to some other point lies: the corners that span the place, as bits.
//! All three: on the face; two: on the edge between them; one: at that corner.
using Feature = unsigned;
constexpr Feature face = 7;

//! A triangle with what finding its nearest point needs.
struct Facet
{
    Vector3 corner, normal;                //!< first corner [m], unit normal
    Vector3 side_1, side_2;                //!< from the first corner to the second and the third [m]
    double d11, d12, d22, inverse;         //!< products of the sides [m^2]; 1/(d11 d22 - d12^2) [1/m^4]
    std::array<std::uint32_t, 3> vertices; //!< numbers of the corners

    //! From the nearest point to p [m], and on which feature that point lies.
    struct Nearest
    {
        Vector3 offset;
        Feature feature;
    };
    DEMENS_INLINE DEMENS_FUNCTION Nearest nearest(Vector3 const& p) const;
    //! Whether all corners that span a feature of another triangle are corners of this one.
    DEMENS_INLINE DEMENS_FUNCTION bool contains(Facet const& other, Feature feature) const
    {
        for (unsigned k = 0; k < 3; ++k) {
            std::uint32_t const v = other.vertices[k];
            if ((feature >> k & 1u) && v != vertices[0] && v != vertices[1] && v != vertices[2])
                return false;
        }
        return true;
    }

  private:
    //! From the nearest point of an edge, given by its direction and length squared, to a point relative to
    //! its start.
    DEMENS_INLINE DEMENS_FUNCTION static Nearest nearest_on_edge(Vector3 const& relative, Vector3 const& side,
                                                                 double length_squared, Feature start,
                                                                 Feature end)
    {
        double const along = dot(relative, side) / length_squared;
        double const t = along < 0 ? 0 : along > 1 ? 1 : along;
        return {relative - t * side, t == 0 ? start : t == 1 ? end : start | end};
    }
};

DEMENS_FUNCTION inline Facet::Nearest Facet::nearest(Vector3 const& p) const
{
    constexpr Feature first = 1, second = 2, third = 4;
    Vector3 const relative = p - corner;
    double const p1 = dot(relative, side_1), p2 = dot(relative, side_2);
    double const s = (p1 * d22 - p2 * d12) * inverse, t = (p2 * d11 - p1 * d12) * inverse;
    if (s >= 0 && t >= 0 && s + t <= 1)
        return {dot(relative, normal) * normal, face};
    // The nearest edge is one that p lies beyond; a little more, for rounding in needles.
    constexpr double little = 1e-3;
    Nearest best{relative, first};
    double least = norm_squared(relative);
    auto const consider = [&](Nearest const& other) {
        if (double const squared = norm_squared(other.offset); squared < least) {
            best = other;
            least = squared;
        }
    };
    if (t < little)
        consider(nearest_on_edge(relative, side_1, d11, first, second));
    if (s < little)
        consider(nearest_on_edge(relative, side_2, d22, first, third));
    if (s + t > 1 - little)
        consider(nearest_on_edge(relative - side_1, side_2 - side_1, d11 - 2 * d12 + d22, second, third));
    return best;
}

} // namespace demens::shape
