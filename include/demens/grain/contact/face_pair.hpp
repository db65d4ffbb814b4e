#pragma once

#include "demens/grain/contact/feature_contact.hpp"
#include "demens/grain/contact/seen_face.hpp"

namespace demens::grain::detail {

//! Where two faces touch: each corner of one that is near the other, and each two edges whose nearest points
//! lie within both, all at their distances.
class FacePair
{
  public:
    //! \param set its state is known
    DEMENS_FUNCTION FacePair(ContactSet& set, ContactAxes const& axes, double rounding_a, double rounding_b)
        : set_(set), axes_(axes), reach_(rounding_a + rounding_b), offset_(0.5 * (rounding_a - rounding_b))
    {
    }

    //! \param height_a, height_b those of the nearest points, beyond which nothing of a core is [m]
    DEMENS_FUNCTION void find(SeenFace& a, SeenFace& b, double height_a, double height_b)
    {
        a.clip(height_b - reach_, 1);
        b.clip(height_a + reach_, -1);
        double const gap = height_b > height_a ? height_b - height_a : 0;
        double const aside = std::sqrt(reach_ * reach_ - gap * gap); // the farthest apart across the normal
        for (int i = 0; i < a.count; ++i)
            if (a.depth[i] > 0 && b.zone.is_near(a.u[i], a.w[i], aside)) {
                ToFace const to = b.nearest_to(a.corner(i));
                add(0.5 * (a.corner(i) + to.place), to.normal, to.gap, 1,
                    feature_id(ContactFeature::vertex_of_a, a.vertices[i], 0));
            }
        for (int j = 0; j < b.count; ++j)
            if (b.depth[j] > 0 && a.zone.is_near(b.u[j], b.w[j], aside)) {
                ToFace const to = a.nearest_to(b.corner(j));
                add(0.5 * (b.corner(j) + to.place), -to.normal, to.gap, 1,
                    feature_id(ContactFeature::vertex_of_b, 0, b.vertices[j]));
            }
        for (int i = 0; i < a.count; ++i)
            for (int j = 0; j < b.count; ++j)
                if (a.sides[i].is_near(b.sides[j], aside))
                    cross_edges(a, i, b, j);
    }

  private:
    //! \param middle between the cores \param part how much it counts
    DEMENS_FUNCTION void add(Vector3 const& middle, Vector3 const& normal, double gap, double part,
                             std::uint32_t feature)
    {
        if (gap < reach_)
            set_.add({axes_(middle + offset_ * normal), axes_(normal), reach_ - gap, part, feature});
    }

    //! From 0 at 0 to 1 at 1 and beyond, level at both.
    DEMENS_INLINE DEMENS_FUNCTION static double ramp(double squared)
    {
        return squared < 1 ? squared * squared * (3 - 2 * squared) : 1;
    }

    //! Two edges count fully where no ends of them touch as well: where their nearest points are farther from
    //! all ends than an end can be to touch, and where they are not nearly parallel. So their contact begins
    //! and ends without a jump where it meets that of an end.
    DEMENS_FUNCTION void cross_edges(SeenFace const& a, int i, SeenFace const& b, int j)
    {
        Vector3 const from_a = a.corner(i), from_b = b.corner(j);
        Vector3 const along_a = a.corner(a.after(i)) - from_a, along_b = b.corner(b.after(j)) - from_b;
        Vector3 const across = cross(along_a, along_b), apart = from_b - from_a;
        double const area = norm_squared(across);
        double const s = dot(cross(apart, along_b), across), t = dot(cross(apart, along_a), across);
        if (!(s > 0 && s < area && t > 0 && t < area))
            return;
        Vector3 const offset = (dot(apart, across) / area) * across;
        double const squared = norm_squared(offset), room = reach_ * reach_ - squared;
        if (room <= 0)
            return;
        double const part_a = s / area, part_b = t / area;
        double const end_a = part_a < 0.5 ? part_a : 1 - part_a, end_b = part_b < 0.5 ? part_b : 1 - part_b;
        double const length_a = norm_squared(along_a), length_b = norm_squared(along_b);
        // The square of the shorter one's length times the sine of their angle.
        double const turned = area / (length_a > length_b ? length_a : length_b);
        double const part = ramp(end_a * end_a * length_a / room) * ramp(end_b * end_b * length_b / room) *
                            ramp(0.25 * turned / room);
        double const distance = set_.state == CoreState::overlapping ? 0 : std::sqrt(squared);
        add(from_a + part_a * along_a + 0.5 * offset, distance > 0 ? offset / distance : Vector3{0, 0, 1},
            distance > 0 ? distance : offset.z, part,
            feature_id(ContactFeature::edges, a.edges[i], b.edges[j]));
    }

    ContactSet& set_;
    ContactAxes const& axes_;
    double reach_, offset_;
};

} // namespace demens::grain::detail
