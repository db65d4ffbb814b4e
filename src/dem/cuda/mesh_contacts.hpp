#pragma once

#include "demens/shape/facet.hpp"
#include "demens/shape/triangle_tree.hpp"
#include "src/dem/cuda/view.hpp"

namespace demens::dem::cuda {

//! A mesh as a device has it.
struct MeshView
{
    shape::Facet const* facets;
    shape::TreeView tree;
};
DEMENS_INLINE DEMENS_FUNCTION MeshView mesh_of(View const& v, PlacedMesh const& mesh)
{
    return {v.facets + mesh.at.facet, {v.nodes + mesh.at.node, v.orders + mesh.at.facet}};
}

//! A sphere in a mesh's coordinates [m].
struct SphereAtMesh
{
    Vector3 position;
    double radius;
    double reach; //!< distance of the centre within which a triangle counts
};

//! Whether any triangle is within reach.
DEMENS_FUNCTION inline bool is_near(MeshView const& mesh, SphereAtMesh const& sphere)
{
    bool found = false;
    double const squared = sphere.reach * sphere.reach;
    mesh.tree.for_each_near(sphere.position, sphere.reach, [&](std::uint32_t triangle) {
        found = found || norm_squared(mesh.facets[triangle].nearest(sphere.position).offset) < squared;
    });
    return found;
}

//! Where a sphere touches a mesh, by the rule of MeshContactFinder: the deepest place counts, and others that
//! are minima of the distance along the surface so far as they rise above the planes of the deeper ones.
//!
//! Triangles in reach are few as a rule, and remembered; where they are not, they are found again for each
//! contact: no list of them is kept, however fine the mesh.
class MeshTouch
{
  public:
    struct Contact
    {
        Vector3 offset;  //!< from the nearest point to the centre [m]
        double distance; //!< [m]
        double depth;    //!< that counts of it [m]

        //! From what counts of it to the centre [m].
        DEMENS_FUNCTION Vector3 felt(double radius) const { return ((radius - depth) / distance) * offset; }
    };

    DEMENS_FUNCTION MeshTouch(MeshView const& mesh, SphereAtMesh const& sphere) : mesh_(mesh), sphere_(sphere)
    {
        std::uint32_t count = 0;
        mesh_.tree.for_each_near(sphere_.position, sphere_.reach, [&](std::uint32_t triangle) {
            Candidate candidate;
            if (!is_in_reach(triangle, candidate))
                return;
            if (count < most_remembered)
                triangles_[count] = triangle;
            ++count;
        });
        count_ = count;
    }

    //! Finds contacts, deepest first, and returns how many; `most` + 1 where there are more than that.
    DEMENS_FUNCTION std::uint32_t find(Contact* contacts, std::uint32_t most) const
    {
        std::uint32_t found = 0;
        while (found < count_) {
            Candidate best;
            Contact contact;
            bool any = false;
            for_each([&](Candidate const& c) {
                if (any && !comes_before(c, best))
                    return;
                double const rise = rise_of(c, contacts, found < most ? found : most);
                if (found > 0 && (rise <= 1e-9 * sphere_.radius || is_passed_over(c)))
                    return;
                double const depth = sphere_.radius - c.distance;
                contact = {c.offset, c.distance, found > 0 && rise < depth ? rise : depth};
                best = c;
                any = true;
            });
            if (!any)
                break;
            if (found == most)
                return most + 1;
            contacts[found++] = contact;
        }
        return found;
    }

  private:
    static constexpr std::uint32_t most_remembered = 16;

    struct Candidate
    {
        Vector3 offset;
        double distance;
        shape::Feature feature;
        std::uint32_t triangle;
    };

    DEMENS_FUNCTION static bool comes_before(Candidate const& a, Candidate const& b)
    {
        return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
    }

    DEMENS_FUNCTION bool is_in_reach(std::uint32_t triangle, Candidate& candidate) const
    {
        shape::Facet const& facet = mesh_.facets[triangle];
        shape::Facet::Nearest const nearest = facet.nearest(sphere_.position);
        double const squared = norm_squared(nearest.offset);
        if (!(squared < sphere_.reach * sphere_.reach))
            return false;
        candidate = {nearest.offset, std::sqrt(squared), nearest.feature, triangle};
        if (squared == 0) { // the centre is on the triangle: push along its normal
            candidate.distance = 1e-9 * sphere_.radius;
            candidate.offset = candidate.distance * facet.normal;
        }
        return true;
    }

    //! Visits the triangles in reach, in no order that matters.
    template <class Visit>
    DEMENS_FUNCTION void for_each(Visit const& visit) const
    {
        Candidate candidate;
        if (count_ <= most_remembered) {
            for (std::uint32_t k = 0; k < count_; ++k)
                if (is_in_reach(triangles_[k], candidate))
                    visit(candidate);
            return;
        }
        mesh_.tree.for_each_near(sphere_.position, sphere_.reach, [&](std::uint32_t triangle) {
            if (is_in_reach(triangle, candidate))
                visit(candidate);
        });
    }

    //! How far a place rises above the planes of the deeper ones [m].
    DEMENS_FUNCTION double rise_of(Candidate const& c, Contact const* deeper, std::uint32_t count) const
    {
        double rise = sphere_.reach;
        for (std::uint32_t k = 0; k < count; ++k) {
            double const above = deeper[k].distance - dot(c.offset, deeper[k].offset) / deeper[k].distance;
            rise = above < rise ? above : rise;
        }
        return rise;
    }

    //! Whether a triangle that shares its edge or corner comes nearer.
    DEMENS_FUNCTION bool is_passed_over(Candidate const& c) const
    {
        if (c.feature == shape::face)
            return false;
        bool found = false;
        for_each([&](Candidate const& other) {
            found = found || (other.distance < c.distance &&
                              mesh_.facets[other.triangle].contains(mesh_.facets[c.triangle], c.feature));
        });
        return found;
    }

    MeshView mesh_;
    SphereAtMesh sphere_;
    std::uint32_t count_; //!< of the triangles in reach
    std::uint32_t triangles_[most_remembered];
};

} // namespace demens::dem::cuda
