#pragma once

#include "demens/shape/facet.hpp"
#include "demens/shape/triangle_tree.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace demens::shape {

//! Three corners of each triangle [m], as a file lists them.
using TriangleSoup = std::vector<std::array<Vector3, 3>>;

//! What is doubtful about a mesh, though it can be used: warnings. Errors are a number that is not finite,
//! and no triangle with an area.
struct MeshFaults
{
    std::size_t degenerate = 0;      //!< triangles without area, left out
    std::size_t open_edges = 0;      //!< edges with one triangle: the border of a hole or of an open surface
    std::size_t manifold_faults = 0; //!< edges with more than two triangles
    Vector3 first_degenerate, first_open_edge, first_manifold_fault; //!< where the first of each is [m]

    //! One line on each kind that there is.
    std::vector<std::string> warnings() const;
};

//! A side that triangles share.
struct MeshEdge
{
    std::array<std::uint32_t, 2> vertices;
    std::array<std::uint32_t, 2> facets; //!< the first two of them
    std::uint32_t facet_count;           //!< 2 within a surface, 1 at its border
};

//! A surface of triangles whose corners are shared.
class TriangleMesh
{
  public:
    //! Joins corners that coincide within a millionth of the mesh's size and leaves out triangles without
    //! area. \throws InputError where a number is not finite or nothing is left.
    explicit TriangleMesh(TriangleSoup const& soup);

    //! What a mesh is made of once corners are joined, to be stored.
    struct Parts
    {
        std::vector<Vector3> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles; //!< numbers of vertices; all with an area
        Bounds bounds;                                       //!< of what was joined
    };
    Parts parts() const;
    //! The same mesh again, to the bit. \throws InputError where the parts do not make one.
    static TriangleMesh from_parts(Parts const& parts);

    std::vector<Vector3> const& vertices() const { return vertices_; }
    std::vector<Facet> const& facets() const { return facets_; }
    std::vector<MeshEdge> const& edges() const { return edges_; }
    TriangleTree const& tree() const { return tree_; }
    Bounds const& bounds() const { return bounds_; }
    //! Middle of the bounds, and distance of the farthest corner from it [m].
    Vector3 const& centre() const { return centre_; }
    double extent() const { return extent_; }
    MeshFaults const& faults() const { return faults_; }

  private:
    TriangleMesh() : tree_({}) {}
    void join(TriangleSoup const& soup);
    void add_facet(std::array<std::uint32_t, 3> const& vertices);
    void complete();
    void find_edges();
    std::vector<Bounds> facet_bounds() const;

    Bounds bounds_;
    Vector3 centre_;
    double extent_ = 0;
    std::vector<Vector3> vertices_;
    std::vector<Facet> facets_;
    std::vector<MeshEdge> edges_; //!< in the order of their vertices
    MeshFaults faults_;
    TriangleTree tree_;
};

//! The surface of a box along the axes.
TriangleSoup box_triangles(Vector3 const& lower, Vector3 const& upper);

} // namespace demens::shape
