#pragma once

#include "demens/grain/rounded_hull.hpp"
#include "demens/observe/snapshot.hpp"

namespace demens::observe {

//! Flat faces of bodies, counter-clockwise seen from outside.
struct Polygons
{
    std::vector<Vector3> corners;          //!< [m]
    std::vector<std::int64_t> faces, ends; //!< numbers of corners, face after face; where each face ends
    std::vector<std::int64_t> body;        //!< of each face, its number among the bodies
};

//! Adds a rounded hull: its faces where they are, and along edges and at corners flat ones in the place of
//! what is round.
void add_surface(Polygons& polygons, grain::RoundedHull const& hull, std::int64_t body);

//! The hulls of a snapshot; those whose corners are told apart no more by what was kept of them are left out.
Polygons hull_surfaces(Snapshot const& snapshot);

} // namespace demens::observe
