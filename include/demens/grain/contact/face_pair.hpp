#pragma once

#include "demens/grain/contact/face_candidates.hpp"
#include "demens/grain/contact/feature_contact.hpp"

namespace demens::grain::detail {

//! Where two faces touch, so that the energy of contacts U(overlap) is a function of distances alone, without
//! jumps, and forces along these distances keep it:
//!
//!     sum U(corner of A to face B) + sum U(corner of B to face A) - sum U(corner to corner)
//!         + sum U(edge to edge) product (1 - U(end of one to the other edge) / U(edge to edge))
//!
//! Edges count where their nearest points lie within both. What is taken away is what is counted twice: a
//! contact of edges begins and ends where it meets that of an end, and edges that are nearly parallel touch
//! at their ends; corners that meet count once. Together they are no less than the deepest alone. Corners of
//! one face nearer to each other than the roundings count as one, in the same way (`corner_shares`). A share
//! is the derivative of the sum by the contact's own energy, so that some are negative. The energies' ratio
//! is taken from Hertz' law.
class FacePair
{
  public:
    DEMENS_FUNCTION FacePair(ContactSet& set, double rounding_a, double rounding_b)
        : set_(set), reach_(rounding_a + rounding_b), offset_(0.5 * (rounding_a - rounding_b))
    {
    }

    DEMENS_FUNCTION void find(SeenFace& a, SeenFace& b, FaceCandidates const& candidates)
    {
        bool const any_a = corners(a, b, candidates.corners_a, candidates.short_a, 1);
        bool const any_b = corners(b, a, candidates.corners_b, candidates.short_b, -1);
        if (any_a && any_b)
            corners_that_meet(a, b);
        if (candidates.edges != FaceCandidates::all_edges) {
            for (int k = 0; k < candidates.edges; ++k)
                cross_edges(a, candidates.edge_a[k], b, candidates.edge_b[k]);
            return;
        }
        for (int i = 0; i < a.count; ++i)
            for (int j = 0; j < b.count; ++j)
                cross_edges(a, i, b, j);
    }

  private:
    //! \param middle between the cores \param share how much it counts
    DEMENS_FUNCTION void add(Vector3 const& middle, Vector3 const& normal, double gap, double share,
                             std::uint32_t feature)
    {
        if (gap < reach_ && share != 0)
            set_.add({middle + offset_ * normal, normal, reach_ - gap, share, feature});
    }

    //! Corners of a face on another. \param candidates a bit for each that may touch \param sense 1: the face
    //! is that of A; -1: of B. False if none touches.
    DEMENS_FUNCTION bool corners(SeenFace& face, SeenFace const& other, std::uint64_t candidates,
                                 bool has_short_sides, double sense)
    {
        if (candidates == 0)
            return false;
        bool any = false;
        for (int k = 0; k < face.count; ++k) {
            face.overlap[k] = 0;
            face.share[k] = 1;
            if ((candidates >> k & 1U) == 0)
                continue;
            ToFace const to = other.nearest_to(face.corner(k));
            if (to.gap >= reach_)
                continue;
            any = true;
            face.overlap[k] = reach_ - to.gap;
            if (!has_short_sides)
                add_corner(face, k, to, sense);
        }
        if (any && has_short_sides) {
            corner_shares(face);
            for (int k = 0; k < face.count; ++k)
                if (face.overlap[k] > 0)
                    add_corner(face, k, other.nearest_to(face.corner(k)), sense);
        }
        return any;
    }
    DEMENS_FUNCTION void add_corner(SeenFace const& face, int k, ToFace const& to, double sense)
    {
        add(0.5 * (face.corner(k) + to.place), sense * to.normal, to.gap, face.share[k],
            sense > 0 ? feature_id(ContactFeature::vertex_of_a, face.vertices[k], 0)
                      : feature_id(ContactFeature::vertex_of_b, 0, face.vertices[k]));
    }

    //! How much corners count: all of them, less the shallower one of each side as much as its ends are one,
    //! and once more the shallowest as much as all are (as faces, edges and corners add up to one). Of
    //! corners at one place only the deepest is left.
    DEMENS_FUNCTION void corner_shares(SeenFace& face) const
    {
        double all = 1;
        int shallowest = 0;
        for (int k = 0; k < face.count; ++k) {
            int const next = face.after(k);
            double const y = norm_squared(face.corner(next) - face.corner(k)) / (reach_ * reach_);
            double const one = y < 1 ? (1 - y) * (1 - y) * (1 + 2 * y) : 0;
            face.share[face.overlap[next] < face.overlap[k] ? next : k] -= one;
            all *= one;
            shallowest = face.overlap[k] < face.overlap[shallowest] ? k : shallowest;
        }
        face.share[shallowest] += all;
    }

    //! Takes away what corners of A and B count together.
    DEMENS_FUNCTION void corners_that_meet(SeenFace const& a, SeenFace const& b)
    {
        for (int i = 0; i < a.count; ++i)
            for (int j = 0; j < b.count && a.overlap[i] > 0; ++j) {
                Vector3 const apart = b.corner(j) - a.corner(i);
                double const squared = norm_squared(apart);
                if (b.overlap[j] <= 0 || squared >= reach_ * reach_ || squared == 0)
                    continue;
                double const distance = std::sqrt(squared);
                add(a.corner(i) + 0.5 * apart, apart / distance, distance, -a.share[i] * b.share[j],
                    feature_id(ContactFeature::vertices, a.vertices[i], b.vertices[j]));
            }
    }

    //! An end of one edge on the other.
    struct End
    {
        Vector3 middle, offset; //!< the latter from A to B [m]
        double distance;
        double ratio; //!< of its energy to that of the edges
        std::uint32_t feature;
    };
    DEMENS_FUNCTION End end_on(Vector3 const& end, Vector3 const& from, Vector3 const& along, double sense,
                               double overlap, std::uint32_t feature) const
    {
        double const length = norm_squared(along), at = dot(end - from, along);
        double const t = at <= 0 ? 0 : at >= length ? 1 : at / length;
        Vector3 const offset = from + t * along - end;
        double const squared = norm_squared(offset);
        End result{end + 0.5 * offset, sense * offset, 0, 0, feature};
        if (squared < reach_ * reach_ && squared > 0) {
            result.distance = std::sqrt(squared);
            double const depth = (reach_ - result.distance) / overlap;
            result.ratio = depth < 1 ? depth * depth * std::sqrt(depth) : 1;
        }
        return result;
    }

    DEMENS_FUNCTION void cross_edges(SeenFace const& a, int i, SeenFace const& b, int j)
    {
        int const i1 = a.after(i), j1 = b.after(j);
        Vector3 const from_a = a.corner(i), from_b = b.corner(j);
        Vector3 const along_a = a.corner(i1) - from_a, along_b = b.corner(j1) - from_b;
        Vector3 const across = cross(along_a, along_b), apart = from_b - from_a;
        double const area = norm_squared(across);
        double const s = dot(cross(apart, along_b), across), t = dot(cross(apart, along_a), across);
        if (!(s > 0 && s < area && t > 0 && t < area))
            return;
        Vector3 const offset = (dot(apart, across) / area) * across;
        double const squared = norm_squared(offset);
        if (squared >= reach_ * reach_ || squared == 0)
            return;
        double const distance = std::sqrt(squared), overlap = reach_ - distance;
        End const ends[4] = {
            end_on(from_a, from_b, along_b, 1, overlap,
                   feature_id(ContactFeature::vertex_of_a_on_edge, a.vertices[i], b.edges[j])),
            end_on(a.corner(i1), from_b, along_b, 1, overlap,
                   feature_id(ContactFeature::vertex_of_a_on_edge, a.vertices[i1], b.edges[j])),
            end_on(from_b, from_a, along_a, -1, overlap,
                   feature_id(ContactFeature::vertex_of_b_on_edge, a.edges[i], b.vertices[j])),
            end_on(b.corner(j1), from_a, along_a, -1, overlap,
                   feature_id(ContactFeature::vertex_of_b_on_edge, a.edges[i], b.vertices[j1]))};
        double share = 1;
        for (End const& end : ends)
            share *= 1 - end.ratio;
        for (int k = 0; k < 4; ++k) {
            if (ends[k].ratio == 0)
                continue;
            double others = 1;
            for (int l = 0; l < 4; ++l)
                others *= l == k ? 1 : 1 - ends[l].ratio;
            share += ends[k].ratio * others;
            add(ends[k].middle, ends[k].offset / ends[k].distance, ends[k].distance, -others,
                ends[k].feature);
        }
        add(from_a + (s / area) * along_a + 0.5 * offset, offset / distance, distance, share,
            feature_id(ContactFeature::edges, a.edges[i], b.edges[j]));
    }

    ContactSet& set_;
    double reach_, offset_;
};

} // namespace demens::grain::detail
