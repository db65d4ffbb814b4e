#pragma once

#include "demens/grain/contact/seen_face.hpp"

namespace demens::grain {

//! What of two faces may touch for as long as their hulls move by no more than a margin, both together. It
//! spares the search in most steps; what it leaves out touches nothing, so that results do not depend on it.
struct FaceCandidates
{
    static constexpr int most_edges = 20;
    static constexpr std::uint8_t all_edges = 0xff; //!< as their number: there are too many, try all
    std::int32_t face_a = -1, face_b = -1;          //!< of which faces; -1: nothing is known
    std::uint64_t corners_a = 0, corners_b = 0;     //!< a bit for each
    std::uint8_t edge_a[most_edges] = {}, edge_b[most_edges] = {}; //!< pairs of sides
    std::uint8_t edges = 0;
    bool short_a = false, short_b = false; //!< whether faces have sides shorter than the roundings
    bool is_new = false;                   //!< found in the last search of contacts

    bool is_of(int a, int b) const { return face_a == a && face_b == b; }
    void forget() { face_a = -1; }
    //! \param reach the roundings [m] \param margin [m]
    DEMENS_FUNCTION void find(detail::SeenFace const& a, detail::SeenFace const& b, double reach,
                              double margin);

  private:
    DEMENS_FUNCTION static std::uint64_t corners_near(detail::SeenFace const& face,
                                                      detail::SeenFace const& other, double distance)
    {
        std::uint64_t found = 0;
        for (int k = 0; k < face.count; ++k)
            if (other.nearest_to(face.corner(k)).gap < distance)
                found |= std::uint64_t{1} << k;
        return found;
    }
};

DEMENS_FUNCTION inline void FaceCandidates::find(detail::SeenFace const& a, detail::SeenFace const& b,
                                                 double reach, double margin)
{
    double const distance = (reach + margin) * (1 + 1e-9);
    corners_a = corners_near(a, b, distance);
    corners_b = corners_near(b, a, distance);
    short_a = a.shortest_squared() < reach * reach;
    short_b = b.shortest_squared() < reach * reach;
    edges = 0;
    is_new = true;
    for (int i = 0; i < a.count; ++i)
        for (int j = 0; j < b.count; ++j) {
            Vector3 const along_a = a.corner(a.after(i)) - a.corner(i);
            Vector3 const along_b = b.corner(b.after(j)) - b.corner(j);
            if (detail::segments_distance_squared(a.corner(i), along_a, b.corner(j), along_b) >=
                distance * distance)
                continue;
            if (edges == most_edges) {
                edges = all_edges;
                return;
            }
            edge_a[edges] = static_cast<std::uint8_t>(i);
            edge_b[edges++] = static_cast<std::uint8_t>(j);
        }
}

} // namespace demens::grain
