#pragma once

#include "demens/grain/contact/core_gap.hpp"
#include "demens/grain/contact/feature_contact.hpp"

namespace demens::grain {

namespace detail {

//! A face of one core as seen in axes of the pair's contact: u and w across the normal, h along it [m].
struct SeenFace
{
    static constexpr int most = most_face_corners;
    double u[most], w[most], h[most];
    std::uint16_t vertices[most], edges[most];
    int count;
    Vector3 normal; //!< unit, outwards, in the same axes

    DEMENS_INLINE DEMENS_FUNCTION Vector3 corner(int k) const { return {u[k], w[k], h[k]}; }
    DEMENS_INLINE DEMENS_FUNCTION int after(int k) const { return k + 1 < count ? k + 1 : 0; }
};

//! Axes of a contact.
struct ContactAxes
{
    Vector3 u, w, n;

    //! In the axes of the pair.
    DEMENS_INLINE DEMENS_FUNCTION Vector3 operator()(Vector3 const& v) const
    {
        return v.x * u + v.y * w + v.z * n;
    }
    DEMENS_INLINE DEMENS_FUNCTION explicit ContactAxes(Vector3 const& normal)
        : u(any_normal_to(normal)), w(cross(normal, u)), n(normal)
    {
    }
};

//! \param place where a vertex is \param face_normal in the axes of the pair, of any length
template <class Place>
DEMENS_INLINE DEMENS_FUNCTION void see(SeenFace& seen, CoreView const& core, HullFace const& face,
                                       Vector3 const& face_normal, ContactAxes const& axes, Place&& place)
{
    seen.count = face.size;
    for (int k = 0; k < seen.count; ++k) {
        seen.vertices[k] = core.corners[face.first + k];
        seen.edges[k] = core.corner_edges[face.first + k];
        Vector3 const p = place(seen.vertices[k]);
        seen.u[k] = dot(p, axes.u);
        seen.w[k] = dot(p, axes.w);
        seen.h[k] = dot(p, axes.n);
    }
    Vector3 const seen_normal{dot(face_normal, axes.u), dot(face_normal, axes.w), dot(face_normal, axes.n)};
    seen.normal = seen_normal / norm(seen_normal);
}

//! From a place to its nearest one on a face, in axes of the contact.
struct ToFace
{
    Vector3 place;  //!< [m]
    Vector3 normal; //!< unit, towards the face
    double gap;     //!< below 0 behind the face [m]
};
DEMENS_FUNCTION inline ToFace nearest_on(SeenFace const& face, Vector3 const& p)
{
    double const above = dot(face.normal, p - face.corner(0));
    ToFace best{p - above * face.normal, -face.normal, above};
    double least = 1e300;
    for (int k = 0; k < face.count; ++k) {
        Vector3 const from = face.corner(k), side = face.corner(face.after(k)) - from, apart = p - from;
        if (dot(cross(face.normal, side), apart) >= 0)
            continue; // not beyond this side
        double const length = norm_squared(side), along = dot(apart, side);
        double const t = along <= 0 ? 0 : along >= length ? 1 : along / length;
        Vector3 const offset = t * side - apart;
        if (double const squared = norm_squared(offset); squared < least) {
            least = squared;
            double const distance = std::sqrt(squared);
            best = {p + offset, offset / distance, distance};
        }
    }
    return best;
}

//! Of the faces around the vertices between which the nearest point lies that which faces the other core
//! most. \param along the normal of the pair, out of this core, in the core's own axes (of any length)
DEMENS_FUNCTION inline int facing_face(CoreView const& core, std::uint16_t const* vertices, int count,
                                       Vector3 const& along)
{
    int best = -1;
    double most = 0;
    std::uint16_t const first = vertices[0];
    for (std::uint16_t k = core.vertex_face_first[first]; k < core.vertex_face_first[first + 1]; ++k) {
        HullFace const& face = core.faces[core.vertex_faces[k]];
        bool all = true;
        for (int v = 1; v < count && all; ++v) {
            all = false;
            for (std::uint16_t c = 0; c < face.size && !all; ++c)
                all = core.corners[face.first + c] == vertices[v];
        }
        if (double const facing = dot(face.normal, along); all && (best < 0 || facing > most)) {
            most = facing;
            best = core.vertex_faces[k];
        }
    }
    return best;
}

//! Where two faces touch: each corner of one that is near the other, and each two edges whose nearest points
//! lie within both, all at their distances.
class FacePair
{
  public:
    DEMENS_FUNCTION FacePair(ContactSet& set, ContactAxes const& axes, double rounding_a, double rounding_b)
        : set_(set), axes_(axes), reach_(rounding_a + rounding_b), offset_(0.5 * (rounding_a - rounding_b))
    {
    }

    //! \param height_a, height_b those of the nearest points, beyond which nothing of a core is
    DEMENS_FUNCTION void find(SeenFace const& a, SeenFace const& b, double height_a, double height_b)
    {
        for (int i = 0; i < a.count; ++i)
            if (height_b - a.h[i] < reach_) {
                ToFace const to = nearest_on(b, a.corner(i));
                add(0.5 * (a.corner(i) + to.place), to.normal, to.gap, 1,
                    feature_id(ContactFeature::vertex_of_a, a.vertices[i], 0));
            }
        for (int j = 0; j < b.count; ++j)
            if (b.h[j] - height_a < reach_) {
                ToFace const to = nearest_on(a, b.corner(j));
                add(0.5 * (b.corner(j) + to.place), -to.normal, to.gap, 1,
                    feature_id(ContactFeature::vertex_of_b, 0, b.vertices[j]));
            }
        for (int i = 0; i < a.count; ++i)
            if (height_b - a.h[i] < reach_ || height_b - a.h[a.after(i)] < reach_)
                for (int j = 0; j < b.count; ++j)
                    if (b.h[j] - height_a < reach_ || b.h[b.after(j)] - height_a < reach_)
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
        double const turned =
            area / (length_a > length_b ? length_a : length_b); // (shorter length times sine)^2
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

} // namespace detail

//! Where two rounded hulls touch, each a core and its rounding [m].
//!
//! The distance of the cores says whether they do, and its normal which faces face each other. Each corner of
//! such a face that is nearer to the other than the roundings is a contact, with the normal of their
//! distance; so is each place where edges of the two cross, with the normal of the cores. What touches at one
//! place shares a force (`ContactSet::find_shares`). The deepest contact has the cores' distance and normal.
DEMENS_FUNCTION inline ContactSet hull_contacts(CorePair const& pair, double rounding_a, double rounding_b,
                                                PairMemory& memory)
{
    using namespace detail;
    ContactSet set;
    double const reach = rounding_a + rounding_b;
    CoreGap const nearest = core_gap(pair, reach, memory);
    set.state = nearest.state;
    if (nearest.state == CoreState::apart || nearest.gap >= reach)
        return set;
    Vector3 const& n = nearest.normal;
    int const face_a = facing_face(pair.a, nearest.vertex_a, nearest.size, n);
    int const face_b = facing_face(pair.b, nearest.vertex_b, nearest.size, pair.images.inverse(-n));
    if (face_a >= 0 && face_b >= 0) {
        SeenFace a, b;
        ContactAxes const axes(n);
        HullFace const &of_a = pair.a.faces[face_a], &of_b = pair.b.faces[face_b];
        see(a, pair.a, of_a, of_a.normal, axes, [&](std::uint16_t v) { return pair.vertex_a(v); });
        see(b, pair.b, of_b, pair.images(of_b.normal), axes,
            [&](std::uint16_t v) { return pair.vertex_b(v); });
        FacePair(set, axes, rounding_a, rounding_b).find(a, b, dot(nearest.on_a, n), dot(nearest.on_b, n));
    }
    if (set.count == 0)
        set.add({0.5 * (nearest.on_a + nearest.on_b + (rounding_a - rounding_b) * n), n, reach - nearest.gap,
                 1, feature_id(ContactFeature::edges, nearest.vertex_a[0], nearest.vertex_b[0])});
    else if (set.count > 1)
        set.find_shares(reach);
    return set;
}

} // namespace demens::grain
