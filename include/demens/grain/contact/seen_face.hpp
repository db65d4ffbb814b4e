#pragma once

#include "demens/grain/contact/core.hpp"

namespace demens::grain::detail {

//! From a place to its nearest one on a face.
struct ToFace
{
    Vector3 place;  //!< [m]
    Vector3 normal; //!< unit, towards the face
    double gap;     //!< below 0 behind the face [m]
};

//! A face of a core in the axes of the pair. Not initialised where it is not filled.
struct SeenFace
{
    static constexpr int most = most_face_corners;
    double x[most], y[most], z[most];  //!< of the corners, counter-clockwise seen from outside [m]
    double overlap[most], share[most]; //!< of corners that touch: 0 for others [m]; how much each counts
    std::uint16_t const* vertices;     //!< of the corners
    std::uint16_t const* edges;        //!< from each corner to the next
    int count;
    Vector3 normal; //!< unit, outwards

    //! A face of the first core of a pair.
    DEMENS_INLINE DEMENS_FUNCTION void see_a(CorePair const& pair, int face)
    {
        begin(pair.a, face);
        for (int k = 0; k < count; ++k)
            put(k, pair.vertex_a(vertices[k]));
        normal = pair.a.faces[face].normal;
    }
    //! A face of the second.
    DEMENS_INLINE DEMENS_FUNCTION void see_b(CorePair const& pair, int face)
    {
        begin(pair.b, face);
        for (int k = 0; k < count; ++k)
            put(k, pair.vertex_b(vertices[k]));
        normal = (1 / pair.scale_b) * pair.images(pair.b.faces[face].normal);
    }

    DEMENS_INLINE DEMENS_FUNCTION Vector3 corner(int k) const { return {x[k], y[k], z[k]}; }
    DEMENS_INLINE DEMENS_FUNCTION int after(int k) const { return k + 1 < count ? k + 1 : 0; }

    //! Square of the length of the shortest side [m^2].
    DEMENS_FUNCTION double shortest_squared() const
    {
        double shortest = 1e300;
        for (int k = 0; k < count; ++k) {
            double const squared = norm_squared(corner(after(k)) - corner(k));
            shortest = squared < shortest ? squared : shortest;
        }
        return shortest;
    }

    DEMENS_INLINE DEMENS_FUNCTION ToFace nearest_to(Vector3 const& p) const
    {
        double const above = dot(normal, p - corner(0));
        ToFace best{p - above * normal, -normal, above};
        double least = 1e300;
        Vector3 nearest;
        for (int k = 0; k < count; ++k) {
            Vector3 const from = corner(k), side = corner(after(k)) - from, apart = p - from;
            if (dot(cross(normal, side), apart) >= 0)
                continue; // not beyond this side
            double const length = norm_squared(side), along = dot(apart, side);
            double const t = along <= 0 ? 0 : along >= length ? 1 : along / length;
            Vector3 const offset = t * side - apart;
            if (double const squared = norm_squared(offset); squared < least) {
                least = squared;
                nearest = offset;
            }
        }
        if (least < 1e300) {
            double const distance = std::sqrt(least);
            best = {p + nearest, nearest / distance, distance};
        }
        return best;
    }

  private:
    DEMENS_INLINE DEMENS_FUNCTION void put(int k, Vector3 const& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
    DEMENS_INLINE DEMENS_FUNCTION void begin(CoreView const& core, int face)
    {
        HullFace const& of = core.faces[face];
        count = of.size;
        vertices = core.corners + of.first;
        edges = core.corner_edges + of.first;
    }
};

//! Square of the distance of two segments, from `a` along `u` and from `b` along `v` (Ericson 2005) [m^2].
DEMENS_FUNCTION inline double segments_distance_squared(Vector3 const& a, Vector3 const& u, Vector3 const& b,
                                                        Vector3 const& v)
{
    auto const clamp = [](double x) { return x < 0 ? 0 : x > 1 ? 1 : x; };
    Vector3 const r = a - b;
    double const uu = norm_squared(u), vv = norm_squared(v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    double const area = uu * vv - uv * uv;
    double s = area > 1e-14 * uu * vv ? clamp((uv * vr - ur * vv) / area) : 0;
    double t = vv > 0 ? (uv * s + vr) / vv : 0;
    if (t < 0 || t > 1 || vv == 0) {
        t = clamp(t);
        s = uu > 0 ? clamp((uv * t - ur) / uu) : 0;
    }
    return norm_squared(r + s * u - t * v);
}

DEMENS_INLINE DEMENS_FUNCTION bool has_corner(CoreView const& core, HullFace const& face,
                                              std::uint16_t vertex)
{
    bool found = false;
    for (std::uint16_t c = 0; c < face.size; ++c)
        found |= core.corners[face.first + c] == vertex;
    return found;
}

//! Of the faces around the vertices between which the nearest point lies that which faces the other core
//! most. \param along the normal of the pair, out of this core, in the core's own axes (of any length)
//! \param likely the face to try first, or -1: three vertices have no other
DEMENS_FUNCTION inline int facing_face(CoreView const& core, std::uint16_t const* vertices, int count,
                                       Vector3 const& along, int likely)
{
    std::uint16_t const first = vertices[0];
    std::uint16_t others[2] = {};
    int distinct = 0;
    for (int v = 1; v < count; ++v)
        if (vertices[v] != first && (distinct == 0 || vertices[v] != others[0]))
            others[distinct++] = vertices[v];
    auto const has_others = [&](HullFace const& face) {
        for (int v = 0; v < distinct; ++v)
            if (!has_corner(core, face, others[v]))
                return false;
        return true;
    };
    if (distinct == 2 && likely >= 0 && has_corner(core, core.faces[likely], first) &&
        has_others(core.faces[likely]))
        return likely;
    int best = -1;
    double most = 0;
    for (std::uint16_t k = core.vertex_face_first[first]; k < core.vertex_face_first[first + 1]; ++k) {
        HullFace const& face = core.faces[core.vertex_faces[k]];
        double const facing = dot(face.normal, along);
        if ((best < 0 || facing > most) && has_others(face)) {
            most = facing;
            best = core.vertex_faces[k];
        }
    }
    return best;
}

} // namespace demens::grain::detail
