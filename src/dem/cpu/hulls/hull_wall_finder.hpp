#pragma once

#include "demens/dem/wall.hpp"
#include "demens/grain/contact/hull_contacts.hpp"
#include "src/dem/cpu/hulls/hull_mesh_finder.hpp"
#include "src/dem/cpu/hulls/hull_party.hpp"

#include <memory>
#include <vector>

namespace demens::dem {

//! Finds where hulls touch walls, in the axes of space.
//!
//! Flat walls whose edges are out of reach, and the hollow sides of cylinders and cones, are touched by
//! vertices, each a ball of the rounding's radius. Near its edge a flat wall is a polygon without rounding, a
//! disc one of 48 sides. Outer sides and rims of cylinders and cones are touched by vertices and, where an
//! edge or a face is nearer than these, in the nearest place. Of the four sides of a round wall only
//! `RoundSide::near` touches hulls. Meshes: see `HullMeshFinder`.
class HullWallFinder
{
  public:
    //! Corners of the polygon that a wall is near its edge: those that a memory may name.
    static std::size_t corners_of(WallShape const& shape);

    //! \return whether a mesh cuts the core, which is no contact any more
    bool find(HullParty const& hull, double reach, WallShape const& shape, std::uint32_t wall,
              grain::PairMemory& memory, grain::ContactSet& set);

  private:
    //! A flat wall about its centre, in its own axes.
    struct Polygon
    {
        double half_u = 0, half_v = 0;     //!< what it was made for [m]
        std::unique_ptr<grain::Hull> core; //!< none: not yet
    };
    struct FlatWall
    {
        Vector3 centre;
        Rotation axes; //!< z across the wall
        double half_u, half_v;
        bool is_round, is_near_edge;
    };

    void find_flat(HullParty const& hull, FlatWall const& flat, std::uint32_t wall, grain::PairMemory& memory,
                   grain::ContactSet& set);
    grain::Hull const& polygon(FlatWall const& flat, std::uint32_t wall);

    std::vector<Polygon> polygons_; //!< by wall
    HullMeshFinder meshes_;
    grain::Hull point_ = grain::point_hull();
};

} // namespace demens::dem
