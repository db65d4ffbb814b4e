#pragma once

#include "demens/shape/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace demens::dem {

//! Edges and corners of a mesh that stand out, so that the face or the edge of a polyhedron may lie on them.
//! From which side they are seen matters: a ridge is a valley from behind. Where triangles go on into each
//! other without a bend nothing stands out, however fine they are.
class MeshFeatures
{
  public:
    explicit MeshFeatures(shape::TriangleMesh const& mesh);

    //! The edge of a triangle from its k-th corner to the next.
    std::uint32_t edge(std::uint32_t triangle, unsigned k) const { return edges_of_[triangle][k]; }
    //! Whether something touches an edge in a direction (unit) from it. A sharp one is touched beside what
    //! its triangles touch, as the side of a polygon is, a gentle one where its triangles bend away on both
    //! sides: there something that rolls over a fine mesh goes from one edge to the next.
    bool edge_touches(std::uint32_t edge, Vector3 const& direction) const
    {
        return touches(edges_[edge].stands, direction, edges_[edge].inwards.data(), 2);
    }
    //! The same of a corner.
    bool corner_touches(std::uint32_t vertex, Vector3 const& direction) const
    {
        return touches(corners_[vertex], direction, directions_.data() + directions_first_[vertex],
                       directions_first_[vertex + 1] - directions_first_[vertex]);
    }
    bool is_sharp_corner(std::uint32_t vertex) const { return corners_[vertex].kind == Kind::sharp; }
    //! Whether an edge or a corner of a triangle may touch something.
    //! \param in_front on the side of its normal; else on the other one
    bool may_touch(std::uint32_t triangle, bool in_front) const
    {
        return may_touch_[triangle][in_front ? 0 : 1] != 0;
    }

  private:
    enum class Kind : std::uint8_t
    {
        flat,
        gentle,
        sharp
    };
    //! How something stands out: what goes on from it lies to one side.
    struct Stand
    {
        Kind kind = Kind::flat;
        Vector3 side; //!< unit
    };
    struct Edge
    {
        std::array<Vector3, 2> inwards; //!< from the edge into its first two triangles, unit; 0: none there
        Stand stands;
    };
    //! Of what goes on in these directions.
    static Stand stand(Vector3 const* directions, std::size_t count);
    static bool touches(Stand const& stand, Vector3 const& direction, Vector3 const* directions,
                        std::size_t count);
    static bool may_touch(Stand const& stand, Vector3 const& normal);
    void find_edges(shape::TriangleMesh const& mesh);
    void find_corners(shape::TriangleMesh const& mesh);

    std::vector<std::array<std::uint32_t, 3>> edges_of_; //!< of each triangle
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> directions_first_; //!< of each vertex, and one more
    std::vector<Vector3> directions_;             //!< of the edges from each vertex, unit
    std::vector<Stand> corners_;                  //!< of each vertex
    std::vector<std::array<char, 2>> may_touch_;
};

} // namespace demens::dem
