#pragma once

#include "demens/grain/contact/core.hpp"

namespace demens::grain::detail {

//! Axes of a contact: u and w across its normal n, unit vectors in the axes of the pair.
struct ContactAxes
{
    Vector3 u, w, n;

    DEMENS_INLINE DEMENS_FUNCTION explicit ContactAxes(Vector3 const& normal)
        : u(any_normal_to(normal)), w(cross(normal, u)), n(normal)
    {
    }
    //! In the axes of the pair.
    DEMENS_INLINE DEMENS_FUNCTION Vector3 operator()(Vector3 const& v) const
    {
        return v.x * u + v.y * w + v.z * n;
    }
};

//! A part of the plane across the normal, with sides along u and w [m].
struct Box
{
    double from_u, to_u, from_w, to_w;

    static constexpr double far = 1e300;
    DEMENS_INLINE DEMENS_FUNCTION void include(double u, double w)
    {
        from_u = u < from_u ? u : from_u, to_u = u > to_u ? u : to_u;
        from_w = w < from_w ? w : from_w, to_w = w > to_w ? w : to_w;
    }
    DEMENS_INLINE DEMENS_FUNCTION bool is_near(double u, double w, double distance) const
    {
        return u > from_u - distance && u < to_u + distance && w > from_w - distance && w < to_w + distance;
    }
    DEMENS_INLINE DEMENS_FUNCTION bool is_near(Box const& b, double distance) const
    {
        return b.to_u > from_u - distance && b.from_u < to_u + distance && b.to_w > from_w - distance &&
               b.from_w < to_w + distance;
    }
};

//! From a place to its nearest one on a face, in axes of the contact.
struct ToFace
{
    Vector3 place;  //!< [m]
    Vector3 normal; //!< unit, towards the face
    double gap;     //!< below 0 behind the face [m]
};

//! A face of a core in axes of a contact, and what of it may touch. Not initialised where it is not filled.
struct SeenFace
{
    static constexpr int most = most_face_corners;
    double u[most], w[most], h[most];  //!< corners [m]; h along the normal of the contact
    double depth[most];                //!< of corners, beyond the height from which on they may touch [m]
    double overlap[most], share[most]; //!< of corners that touch: 0 for others [m]; how much each counts
    Box sides[most];                   //!< what of each side may touch
    Box zone;                          //!< all of that
    std::uint16_t vertices[most], edges[most];
    int count;
    double shortest; //!< square of the shortest side's length [m^2]
    Vector3 normal;  //!< unit, outwards

    DEMENS_INLINE DEMENS_FUNCTION Vector3 corner(int k) const { return {u[k], w[k], h[k]}; }
    DEMENS_INLINE DEMENS_FUNCTION int after(int k) const { return k + 1 < count ? k + 1 : 0; }

    //! \param to_u, to_w, to_h what gives a vertex' place in axes of the contact, from that of `origin`
    DEMENS_FUNCTION void see(CoreView const& core, HullFace const& face, Vector3 const& to_u,
                             Vector3 const& to_w, Vector3 const& to_h, Vector3 const& origin)
    {
        count = face.size;
        for (int k = 0; k < count; ++k) {
            vertices[k] = core.corners[face.first + k];
            edges[k] = core.corner_edges[face.first + k];
            Vector3 const& v = core.vertices[vertices[k]];
            u[k] = origin.x + dot(v, to_u);
            w[k] = origin.y + dot(v, to_w);
            h[k] = origin.z + dot(v, to_h);
        }
        shortest = Box::far;
        for (int k = 0; k < count; ++k) {
            double const squared = norm_squared(corner(after(k)) - corner(k));
            shortest = squared < shortest ? squared : shortest;
        }
        normal = {dot(face.normal, to_u), dot(face.normal, to_w), dot(face.normal, to_h)};
    }

    //! Finds what may touch: what is beyond a height. \param up 1 upwards, -1 downwards
    DEMENS_FUNCTION void clip(double height, double up)
    {
        for (int k = 0; k < count; ++k)
            depth[k] = up * (h[k] - height);
        zone = {Box::far, -Box::far, Box::far, -Box::far};
        for (int k = 0; k < count; ++k) {
            int const next = after(k);
            Box& side = sides[k];
            side = {Box::far, -Box::far, Box::far, -Box::far};
            if (depth[k] <= 0 && depth[next] <= 0)
                continue;
            if (depth[k] > 0)
                side.include(u[k], w[k]);
            if (depth[next] > 0)
                side.include(u[next], w[next]);
            if (depth[k] <= 0 || depth[next] <= 0) {
                double const t = depth[k] / (depth[k] - depth[next]);
                side.include(u[k] + t * (u[next] - u[k]), w[k] + t * (w[next] - w[k]));
            }
            zone.include(side.from_u, side.from_w);
            zone.include(side.to_u, side.to_w);
        }
    }

    DEMENS_FUNCTION ToFace nearest_to(Vector3 const& p) const
    {
        double const above = dot(normal, p - corner(0));
        ToFace best{p - above * normal, -normal, above};
        double least = 1e300;
        for (int k = 0; k < count; ++k) {
            Vector3 const from = corner(k), side = corner(after(k)) - from, apart = p - from;
            if (dot(cross(normal, side), apart) >= 0)
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
};

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
        double const facing = dot(face.normal, along);
        bool all = best < 0 || facing > most;
        for (int v = 1; v < count && all; ++v) {
            all = vertices[v] == first;
            for (std::uint16_t c = 0; c < face.size && !all; ++c)
                all = core.corners[face.first + c] == vertices[v];
        }
        if (all) {
            most = facing;
            best = core.vertex_faces[k];
        }
    }
    return best;
}

} // namespace demens::grain::detail
