#pragma once

#include "demens/dem/wall.hpp"
#include "demens/grain/contact/feature_contact.hpp"

#include <optional>
#include <vector>

namespace demens::dem {

//! The flat walls that one hull may touch, some of which may go on into each other: rectangles that share an
//! edge are felt as one. Where a wall ends and another of the same plane goes on, its edge and its corners
//! touch nothing, and a vertex that both have is touched by the first of them.
class FlatSeams
{
  public:
    //! The walls of the next hull. \param rounding of its edges; planes that are no further from each other
    //! than 1e-4 of it are one, and edges meet [m]
    void begin(double rounding);
    void add(WallShape const& shape);

    //! Whether two of them go on into each other, as far as planes tell. \param a, b in the order in which
    //! they were added
    bool are_of_one_plane(std::size_t a, std::size_t b) const;
    //! Whether what a hull touches of one of them belongs to another.
    bool is_of_another(std::size_t wall, grain::FeatureContact const& contact) const;

  private:
    struct Flat
    {
        Vector3 centre, axis_u, axis_v, across;
        double half_u, half_v; //!< of a disc its radius, and below 0

        bool covers(Vector3 const& place, double tolerance) const;
    };
    template <class Shape>
    static std::optional<Flat> flat_of(Shape const& shape);

    std::vector<std::optional<Flat>> walls_; //!< none: it is not flat
    double rounding_ = 0, tolerance_ = 0;    // [m]
};

} // namespace demens::dem
