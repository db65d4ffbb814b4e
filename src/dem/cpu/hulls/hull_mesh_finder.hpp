#pragma once

#include "demens/dem/wall_shape.hpp"
#include "demens/grain/contact/hull_contacts.hpp"
#include "src/dem/cpu/hulls/hull_party.hpp"
#include "src/dem/cpu/hulls/mesh_features.hpp"
#include "src/dem/cpu/mesh_contacts.hpp"

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace demens::dem {

//! Finds where hulls touch a mesh.
//!
//! Each vertex of a hull touches as the ball of its rounding does (`MeshContactFinder`): flat places once,
//! however fine the triangles, both sides of a valley. Edges and corners of the mesh that stand out touch
//! edges and faces of the hull, as those of other hulls do (`grain::hull_contacts`, of each triangle), and
//! each counts once, whichever of its triangles meets it first. It remembers nothing from step to step.
class HullMeshFinder
{
  public:
    //! Adds contacts in the axes of space; their features are told by numbers that may be those of others, so
    //! that directions help to tell them apart. \param reach radius of the sphere about the hull's centre
    //! that holds it [m] \return whether the mesh cuts the core
    bool find(HullParty const& hull, double reach, Mesh const& wall, std::uint32_t number,
              grain::ContactSet& set);

  private:
    //! What is known of a mesh, by the wall.
    struct Known
    {
        std::shared_ptr<shape::TriangleMesh const> mesh;
        std::unique_ptr<MeshFeatures> features;
    };
    MeshFeatures const& features_of(Mesh const& wall, std::uint32_t number);
    bool add_vertices(HullParty const& hull, shape::TriangleMesh const& mesh, grain::ContactSet& set);
    bool add_ridges(HullParty const& hull, shape::TriangleMesh const& mesh, MeshFeatures const& features,
                    std::uint32_t triangle, grain::ContactSet& set);
    //! Whether a feature of the hull has not met this edge or vertex of the mesh yet.
    bool is_first(std::uint32_t feature, std::uint32_t of_mesh)
    {
        return seen_.insert({feature / grain::features_of_second, of_mesh}).second;
    }

    std::vector<Known> known_;
    std::vector<NearTriangle> near_;
    MeshContactFinder balls_;
    grain::ContactSet of_triangle_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen_; //!< features of the hull and of the mesh
    grain::Hull triangle_ = grain::flat_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
};

} // namespace demens::dem
