#pragma once

#include "demens/grain/hull.hpp"
#include "demens/shape/triangle_mesh.hpp"

namespace demens::grain {

//! The usual four numbers of a polyhedron.
struct SuperquadricHull
{
    double horizontal_aspect = 1; //!< longer horizontal diameter over the shorter one
    double vertical_aspect = 1;   //!< vertical diameter over the shorter horizontal one
    int corners = 20;
    double degree = 2; //!< 2: an ellipsoid; the larger, the nearer to a box
};

//! A hull with its corners on |x/a|^n + |y/b|^n + |z/c|^n = 1, where a : b : c = horizontal_aspect : 1 :
//! vertical_aspect, its diameter along y 1 m; scale it as is wanted. Where the corners lie is not told by the
//! four numbers: here in directions that are spread evenly over the sphere (a spiral, then pushed apart like
//! equal charges) before they are stretched with the axes. \throws InputError for aspect ratios that are not
//! above 0, fewer than four corners or too many, or a degree below 1.1 or above 20; `origin` stands before
//! the message
Hull superquadric_hull(SuperquadricHull const& shape, std::string const& origin);

//! The hull of a surface, and what it takes too much.
struct SurfaceHull
{
    Hull hull;
    double volume_error; //!< of the hull, over the surface's volume: 0 for a convex one
    std::string warning; //!< where the surface is not convex; else empty
};

//! \throws InputError where the surface is not closed, or its hull is refused
SurfaceHull surface_hull(shape::TriangleMesh const& mesh, std::string const& origin);

//! Corners from a table with the columns x, y and z, as `read_clump` reads spheres. \param scale [m] per unit
Hull read_hull(std::string const& text, std::string const& origin, double scale);

} // namespace demens::grain
