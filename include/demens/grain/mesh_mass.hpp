#pragma once

#include "demens/grain/mass_properties.hpp"
#include "demens/shape/triangle_mesh.hpp"

#include <string>

namespace demens::grain {

//! Of what a closed surface of triangles holds, exact but for rounding: signed tetrahedra. Negative where
//! the corners go round clockwise seen from outside. A surface that is not closed gives no meaning.
VolumeMoments volume_moments(shape::TriangleMesh const& mesh);
//! The same for a surface of either sense. \throws InputError where the surface is not closed or holds no
//! volume; `origin` stands before the message.
MassProperties mass_properties(shape::TriangleMesh const& mesh, std::string const& origin);

//! Of the tetrahedron from the origin to three corners, signed (Tonon 2004).
VolumeMoments of_tetrahedron(Vector3 const& a, Vector3 const& b, Vector3 const& c);

} // namespace demens::grain
