#pragma once

#include "demens/shape/triangle_mesh.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/wall_offset.hpp"

#include <span>

namespace demens::dem {

//! Appends the triangles that are nearer to a sphere's surface than `reach` [m], nearest first. The sphere is
//! in the mesh's coordinates.
void append_near_triangles(std::vector<NearTriangle>& near, shape::TriangleMesh const& mesh,
                           Vector3 const& position, double radius, double reach);

//! Finds where a sphere touches a mesh.
//!
//! Of all places within reach the deepest one counts. Another one counts if it is a minimum of the distance
//! along the surface (no triangle that shares its edge or corner comes nearer) and only so far as it rises
//! above the tangent planes of the deeper ones: what a plane there would have taken already is not felt
//! twice. Flat and convex places are one contact, however fine the triangles; two sides of a corner are two;
//! and what lies between, the facets of a hollow, goes from one to the other without a jump.
class MeshContactFinder
{
  public:
    //! A sphere in the mesh's coordinates [m].
    struct Sphere
    {
        Vector3 position;
        double radius;
        double reach; //!< distance of the centre within which a triangle counts
    };
    //! From each contact's point to the centre [m], deepest first. Looks at the triangles that are due after
    //! the bodies have travelled so far [m], and finds when they are due next.
    std::span<Vector3 const> find(shape::TriangleMesh const& mesh, std::span<NearTriangle> near,
                                  double travelled, Sphere const& sphere);

    //! How many of the triangles that are due are in reach, and from where to the centre for the last of
    //! them: where there is one, it is the contact. Finds when they are due next.
    struct InReach
    {
        int count;
        Vector3 offset; //!< [m]
    };
    static InReach look(shape::TriangleMesh const& mesh, std::span<NearTriangle> near, double travelled,
                        Sphere const& sphere);

  private:
    struct Candidate
    {
        double distance;
        Vector3 offset;
        shape::Feature feature;
        shape::Facet const* facet;
    };
    void collect(shape::TriangleMesh const& mesh, std::span<NearTriangle> near, double travelled,
                 Sphere const& sphere);
    //! Whether a triangle that shares its edge or corner comes nearer.
    bool is_passed_over(std::size_t candidate) const;

    std::vector<Candidate> candidates_; //!< nearest first
    std::vector<Vector3> offsets_;
    std::vector<std::size_t> accepted_;
};

//! Offset of a slot without a contact [m].
constexpr Vector3 out_of_reach{1e100, 0, 0};

//! The offset of a contact that has parted: along the one it had, a little longer than `reach` [m].
inline Vector3 parted(Vector3 const& offset, double reach)
{
    return ((1 + 1e-6) * reach / norm(offset)) * offset;
}

//! Gives contacts their slots in a patch.
class SlotAssignment
{
  public:
    //! A contact takes the history of the one whose normal was nearest to its own. Slots that had a contact
    //! and have none now are `parted`, the others `out_of_reach`. There are at most as many contacts as
    //! slots.
    void assign(ContactList& list, MeshPatch const& patch, std::span<Vector3 const> contacts, double reach);

  private:
    std::vector<Vector3> offset_;
    std::vector<char> taken_, placed_;
};

} // namespace demens::dem
