#pragma once

#include "demens/grain/hull.hpp"

namespace demens::grain {

//! A hull that lies somewhere, on the host or on a device, as contacts see it. Points and polygons too.
struct CoreView
{
    Vector3 const* vertices;
    std::uint16_t vertex_count;
    std::uint16_t const* neighbour_first; //!< [vertices + 1]
    std::uint16_t const* neighbours;
    HullFace const* faces;
    std::uint16_t const* corners;           //!< of all faces, one after another
    std::uint16_t const* corner_edges;      //!< the edge from each corner to the next
    std::uint16_t const* vertex_face_first; //!< [vertices + 1]
    std::uint16_t const* vertex_faces;

    explicit CoreView(Hull const& hull)
        : vertices(hull.vertices().data()), vertex_count(static_cast<std::uint16_t>(hull.vertices().size())),
          neighbour_first(hull.neighbours().first.data()), neighbours(hull.neighbours().numbers.data()),
          faces(hull.faces().data()), corners(hull.all_corners().data()),
          corner_edges(hull.edges_of_corners().data()),
          vertex_face_first(hull.faces_of_vertices().first.data()),
          vertex_faces(hull.faces_of_vertices().numbers.data())
    {
    }

    //! The vertex farthest along a direction, found uphill from any other; on a convex body a vertex with no
    //! higher neighbour is the highest.
    DEMENS_INLINE DEMENS_FUNCTION std::uint16_t farthest(Vector3 const& along, std::uint16_t from) const
    {
        double height = dot(vertices[from], along);
        while (true) {
            std::uint16_t best = from;
            for (std::uint16_t k = neighbour_first[from]; k < neighbour_first[from + 1]; ++k)
                if (double const other = dot(vertices[neighbours[k]], along); other > height) {
                    height = other;
                    best = neighbours[k];
                }
            if (best == from)
                return best;
            from = best;
        }
    }
};

//! Where a core lies: grown by the scale first, then turned and shifted.
struct CorePose
{
    Vector3 place; //!< [m]
    Rotation rotation = {};
    double scale = 1; //!< [m] per unit of the core
};

//! Two cores, the second seen in the axes and from the place of the first: all lengths in m.
struct CorePair
{
    CoreView a, b;
    double scale_a, scale_b;
    Vector3 shift;   //!< place of the second
    Rotation images; //!< of the second one's axes, times its scale

    DEMENS_INLINE DEMENS_FUNCTION CorePair(CoreView const& first, CorePose const& of_a,
                                           CoreView const& second, CorePose const& of_b)
        : CorePair(first, of_a, second, of_b, of_b.place - of_a.place)
    {
    }
    //! \param to_b from the place of the first to that of the second, or to an image of it [m]
    DEMENS_INLINE DEMENS_FUNCTION CorePair(CoreView const& first, CorePose const& of_a,
                                           CoreView const& second, CorePose const& of_b, Vector3 const& to_b)
        : a(first), b(second), scale_a(of_a.scale), scale_b(of_b.scale),
          shift(of_a.rotation.inverse(to_b)), images{of_b.scale * of_a.rotation.inverse(of_b.rotation.x),
                                                     of_b.scale * of_a.rotation.inverse(of_b.rotation.y),
                                                     of_b.scale * of_a.rotation.inverse(of_b.rotation.z)}
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Vector3 vertex_a(std::uint16_t v) const { return scale_a * a.vertices[v]; }
    DEMENS_INLINE DEMENS_FUNCTION Vector3 vertex_b(std::uint16_t v) const
    {
        return shift + images(b.vertices[v]);
    }
    //! The vertices farthest from each other along a direction from the first core to the second.
    DEMENS_INLINE DEMENS_FUNCTION std::uint16_t farthest_a(Vector3 const& along, std::uint16_t from) const
    {
        return a.farthest(along, from);
    }
    DEMENS_INLINE DEMENS_FUNCTION std::uint16_t nearest_b(Vector3 const& along, std::uint16_t from) const
    {
        return b.farthest(-images.inverse(along), from);
    }
};

} // namespace demens::grain
