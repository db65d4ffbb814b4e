#pragma once

#include "demens/grain/clump.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace demens::grain {

//! A flat side of a hull: where n . x = offset.
struct HullFace
{
    Vector3 normal;            //!< unit, outwards
    double offset;             //!< [m]
    std::uint16_t first, size; //!< of its corners in the list of all faces' corners, counter-clockwise
};

struct HullEdge
{
    std::array<std::uint16_t, 2> vertices; //!< ascending
    std::array<std::uint16_t, 2> faces;    //!< the first has the edge in the order of `vertices`
};

//! A list of lists of numbers, one after another.
struct NumberLists
{
    std::vector<std::uint16_t> first; //!< [lists + 1]
    std::vector<std::uint16_t> numbers;

    std::span<std::uint16_t const> operator[](std::size_t list) const
    {
        return {numbers.data() + first[list], numbers.data() + first[list + 1]};
    }
    friend bool operator==(NumberLists const&, NumberLists const&) = default;
};

//! A convex polyhedron. Triangles that lie in one plane are one face; vertices are its true corners only.
class Hull
{
  public:
    //! Of corners and of faces that list them, counter-clockwise seen from outside. Two faces with the same
    //! corners in opposite senses are a flat one, a corner without faces is a point.
    Hull(std::vector<Vector3> vertices, std::vector<std::vector<std::uint16_t>> const& faces);

    std::vector<Vector3> const& vertices() const { return vertices_; }
    std::vector<HullFace> const& faces() const { return faces_; }
    std::vector<HullEdge> const& edges() const { return edges_; } //!< in the order of their vertices
    //! Corners of a face, counter-clockwise seen from outside.
    std::span<std::uint16_t const> corners(HullFace const& face) const
    {
        return {loops_.data() + face.first, face.size};
    }
    //! For each place in the list of all faces' corners the edge to the next corner.
    std::vector<std::uint16_t> const& edges_of_corners() const { return loop_edges_; }
    std::vector<std::uint16_t> const& all_corners() const { return loops_; }
    //! Vertices at the other ends of each vertex's edges; faces around each vertex.
    NumberLists const& neighbours() const { return neighbours_; }
    NumberLists const& faces_of_vertices() const { return faces_of_vertices_; }

    //! The same turned back by `axes` and shifted so that `centre` is at 0: as `in_principal_axes`.
    Hull seen_from(Vector3 const& centre, Quaternion const& axes) const;
    Hull scaled(double factor) const;

  private:
    void find_edges();
    void find_planes();

    std::vector<Vector3> vertices_;
    std::vector<HullFace> faces_;
    std::vector<std::uint16_t> loops_, loop_edges_;
    std::vector<HullEdge> edges_;
    NumberLists neighbours_, faces_of_vertices_;
};

//! A flat convex polygon, both of whose sides are faces: a triangle or rectangle of a wall.
Hull flat_hull(std::vector<Vector3> corners);
//! The core of a ball: one vertex at 0.
Hull point_hull();

//! The smallest convex body around points, by Qhull. Points within 1e-6 of the size of a face's plane are on
//! it. Vertices keep the order of the points, faces that of their corners: Qhull's own order does not show.
//! \throws InputError where there are fewer than four points, they are flat, a number is not finite, or the
//! hull has more than `most_vertices` or a face more than `most_face_corners`; `origin` stands before the
//! message.
Hull convex_hull(std::span<Vector3 const> points, std::string const& origin);
constexpr std::size_t most_vertices = 1024;
constexpr std::size_t most_face_corners = 64;

//! Exact but for rounding.
VolumeMoments volume_moments(Hull const& hull);
double surface_area(Hull const& hull);

} // namespace demens::grain
