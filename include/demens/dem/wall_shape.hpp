#pragma once

#include "demens/base/rotation.hpp"
#include "demens/shape/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <variant>

namespace demens::dem {

// Surfaces without thickness; each touches a sphere at its point nearest to the centre, from either side. All
// that has to be known of a shape stands here: its numbers, its point nearest to another one, its normal
// there, and the line or the corners that it is drawn with.

//! A flat rectangle; a plane is a rectangle larger than the domain.
struct Rectangle
{
    Vector3 centre;         //!< [m]
    Vector3 axis_u, axis_v; //!< orthogonal unit vectors along the sides
    double half_u, half_v;  //!< half lengths of the sides [m]
};

//! A flat disc.
struct Disc
{
    Vector3 centre; //!< [m]
    Vector3 axis;   //!< unit normal
    double radius;  //!< [m]
};

//! Where a round shape touches a sphere: at its point nearest to the centre, or at the nearest one of what is
//! a number of quarter turns away. A sphere about as wide as the hollow that it lies in touches it all
//! around; one wall for each side holds it between four places, and its forces do not jump where it crosses
//! the axis.
enum class RoundSide : std::uint8_t
{
    near,
    left,
    far,
    right
};

//! The lateral surface of a cylinder, open at both ends.
struct Cylinder
{
    Vector3 centre;     //!< middle of the axis [m]
    Vector3 axis;       //!< unit vector
    double half_length; //!< [m]
    double radius;      //!< [m]
    RoundSide side = RoundSide::near;
};

//! The lateral surface of a cone or of a frustum of one, open at both ends.
struct Cone
{
    Vector3 centre;      //!< middle of the axis [m]
    Vector3 axis;        //!< unit vector
    double half_length;  //!< [m]
    double radius_start; //!< at centre - half_length axis [m]
    double radius_end;   //!< at centre + half_length axis [m]
    RoundSide side = RoundSide::near;
};

//! A surface of triangles, which several walls may share. It may touch a sphere in several places.
struct Mesh
{
    std::shared_ptr<shape::TriangleMesh const> mesh;
    Placement placement = {}; //!< of the mesh's own coordinates
};

using WallShape = std::variant<Rectangle, Disc, Cylinder, Cone, Mesh>;

// The numbers of each shape, to be moved, written and read: each is a point, a direction, a number (which
// stays where the shape is put elsewhere), a side or a placement.

void fields(Rectangle& r, auto&& of)
{
    of.point(r.centre), of.direction(r.axis_u), of.direction(r.axis_v), of.number(r.half_u);
    of.number(r.half_v);
}
void fields(Disc& d, auto&& of)
{
    of.point(d.centre), of.direction(d.axis), of.number(d.radius);
}
void fields(Cylinder& c, auto&& of)
{
    of.point(c.centre), of.direction(c.axis), of.number(c.half_length), of.number(c.radius), of.side(c.side);
}
void fields(Cone& c, auto&& of)
{
    of.point(c.centre), of.direction(c.axis), of.number(c.half_length), of.number(c.radius_start);
    of.number(c.radius_end), of.side(c.side);
}
void fields(Mesh& m, auto&& of)
{
    of.placement(m.placement);
}

//! A flat shape with straight sides: its corners, one after another around it [m].
inline std::array<Vector3, 4> corners(Rectangle const& r)
{
    Vector3 const u = r.half_u * r.axis_u, v = r.half_v * r.axis_v;
    return {r.centre - u - v, r.centre + u - v, r.centre + u + v, r.centre - u + v};
}
template <class Shape>
concept Polygon = requires(Shape const& shape)
{
    corners(shape);
};

//! The six sides of a box along the axes, to be touched from inside or outside.
std::array<Rectangle, 6> box_sides(Vector3 const& lower, Vector3 const& upper);

//! A cylinder or cone as the walls that hold a sphere about as wide as the hollow.
template <class Shape>
std::array<Shape, 4> all_sides(Shape shape)
{
    std::array<Shape, 4> sides;
    for (std::uint8_t k = 0; k < 4; ++k) {
        shape.side = RoundSide{k};
        sides[k] = shape;
    }
    return sides;
}

//! A straight line that makes a round shape when it turns about the axis: height along the axis from the
//! centre and distance from the axis, at either end [m].
struct Meridian
{
    double height_start, radius_start, height_end, radius_end;
};
DEMENS_FUNCTION constexpr Meridian meridian(Disc const& disc)
{
    return {0, 0, 0, disc.radius};
}
DEMENS_FUNCTION constexpr Meridian meridian(Cylinder const& cylinder)
{
    return {-cylinder.half_length, cylinder.radius, cylinder.half_length, cylinder.radius};
}
DEMENS_FUNCTION constexpr Meridian meridian(Cone const& cone)
{
    return {-cone.half_length, cone.radius_start, cone.half_length, cone.radius_end};
}

//! A shape that a turn about its own axis maps onto itself.
template <class Shape>
concept RoundShape = requires(Shape const& shape)
{
    meridian(shape);
};

//! Where it is touched.
DEMENS_FUNCTION constexpr RoundSide side_of(Disc const&)
{
    return RoundSide::near;
}
template <RoundShape Shape>
DEMENS_FUNCTION constexpr RoundSide side_of(Shape const& shape)
{
    return shape.side;
}

//! Unit vector from the axis of a round shape towards the side where it touches a sphere at p; on the axis,
//! any one.
template <RoundShape Shape>
DEMENS_INLINE DEMENS_FUNCTION Vector3 outwards(Shape const& shape, Vector3 const& p)
{
    Vector3 const relative = p - shape.centre;
    Vector3 const radial = relative - dot(relative, shape.axis) * shape.axis;
    double const distance = norm(radial);
    Vector3 const out = distance > 0 ? radial / distance : any_normal_to(shape.axis);
    switch (side_of(shape)) {
    case RoundSide::near:
        return out;
    case RoundSide::left:
        return cross(shape.axis, out);
    case RoundSide::far:
        return -out;
    case RoundSide::right:
        return cross(out, shape.axis);
    }
    return out;
}

//! Point of the shape nearest to p [m].
DEMENS_INLINE DEMENS_FUNCTION Vector3 nearest(Rectangle const& r, Vector3 const& p)
{
    Vector3 const relative = p - r.centre;
    double const a = dot(relative, r.axis_u);
    double const b = dot(relative, r.axis_v);
    double const u = a < -r.half_u ? -r.half_u : a > r.half_u ? r.half_u : a;
    double const v = b < -r.half_v ? -r.half_v : b > r.half_v ? r.half_v : b;
    return r.centre + u * r.axis_u + v * r.axis_v;
}
template <RoundShape Shape>
DEMENS_INLINE DEMENS_FUNCTION Vector3 nearest(Shape const& shape, Vector3 const& p)
{
    Meridian const m = meridian(shape);
    Vector3 const relative = p - shape.centre;
    Vector3 const out = outwards(shape, p);
    double const height = dot(relative, shape.axis), distance = dot(relative, out);
    double const dh = m.height_end - m.height_start, dr = m.radius_end - m.radius_start;
    double const along =
        ((height - m.height_start) * dh + (distance - m.radius_start) * dr) / (dh * dh + dr * dr);
    double const t = along < 0 ? 0 : along > 1 ? 1 : along;
    return shape.centre + (m.height_start + t * dh) * shape.axis + (m.radius_start + t * dr) * out;
}

//! Unit normal of the shape at its point nearest to p.
DEMENS_FUNCTION inline Vector3 normal(Rectangle const& r, Vector3 const&)
{
    return cross(r.axis_u, r.axis_v);
}
template <RoundShape Shape>
DEMENS_FUNCTION Vector3 normal(Shape const& shape, Vector3 const& p)
{
    Meridian const m = meridian(shape);
    Vector3 const across =
        (m.height_end - m.height_start) * outwards(shape, p) - (m.radius_end - m.radius_start) * shape.axis;
    return across / norm(across);
}

//! Distance of the farthest point from the centre [m].
inline double extent(Rectangle const& r)
{
    return std::hypot(r.half_u, r.half_v);
}
template <RoundShape Shape>
double extent(Shape const& shape)
{
    Meridian const m = meridian(shape);
    return std::fmax(std::hypot(m.height_start, m.radius_start), std::hypot(m.height_end, m.radius_end));
}
inline double extent(Mesh const& mesh)
{
    return mesh.mesh->extent();
}

// Of any shape.

double extent(WallShape const& shape);
//! The shape put elsewhere.
WallShape placed(WallShape const& shape, Placement const& placement);
//! The shape's centre [m].
Vector3 centre(WallShape const& shape);
//! The part of a spin that moves the shape: all of it, or for a round one the part across its axis [rad/s].
Vector3 displacing_spin(WallShape const& shape, Vector3 const& spin);

} // namespace demens::dem
