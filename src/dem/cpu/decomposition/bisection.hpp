#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/team.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace demens::dem {

//! Space cut into one box a rank, of about equal weight of particles: along the longest extent of what there
//! is, in proportion to the ranks on either side, and again on each side (Berger and Bokhari 1987). The outer
//! boxes have no end, except at the borders of periods.
class Bisection
{
  public:
    using Point = std::array<double, 3>;

    Bisection(int ranks, Periods const& periods);

    //! Cuts anew so that the boxes hold about equal weights [whole numbers]. Collective: all ranks give their
    //! particles and get the same boxes.
    void cut(Team& team, std::span<Place const> places, std::span<double const> weights);

    int owner(Place const& place) const;

    //! Calls `visit(rank)` for all boxes that come nearer to a place than a distance [m], across the borders
    //! of periods too.
    template <class Visit>
    void for_each_near(Place const& place, double distance, Visit&& visit) const
    {
        visit_near(0, {place.x, place.y, place.z}, distance * distance, visit);
    }
    //! Whether a place is in the box of the rank, and no other box comes nearer than a distance [m].
    bool is_deep_inside(int rank, Place const& place, double distance) const;

    //! The cuts, to be stored.
    struct Cuts
    {
        std::vector<std::int64_t> numbers; //!< of each node: first rank, ranks, axis, half
        std::vector<double> borders;       //!< of each node: lower and upper corner, place of the cut [m]
    };
    Cuts cuts() const;
    //! Takes them again. \throws InputError where they are not those of so many ranks.
    void restore(Cuts const& cuts);

  private:
    void find_boxes_of_ranks();

    //! A box of one rank, or two halves.
    struct Node
    {
        int first_rank, ranks;
        Point lower, upper; //!< [m]; infinite where the box has no end
        int axis = 0;
        double at = 0; //!< what is below it on the axis is in the first half
        int half = -1; //!< number of the first half's node, the other's is one more; -1: a rank's box
    };
    struct Cutting;
    //! Halves nodes of which each has several ranks; returns the halves.
    std::vector<int> halve(Cutting const& cutting, std::vector<int> const& nodes);

    double squared_distance(Node const& node, Point const& p) const;

    template <class Visit>
    void visit_near(int number, Point const& p, double squared, Visit& visit) const
    {
        Node const& node = nodes_[static_cast<std::size_t>(number)];
        if (squared_distance(node, p) >= squared)
            return;
        if (node.half < 0)
            visit(node.first_rank);
        else
            for (int const half : {node.half, node.half + 1})
                visit_near(half, p, squared, visit);
    }

    int ranks_;
    std::array<Period, 3> periods_;
    std::vector<Node> nodes_;      //!< the first one is all space
    std::vector<int> box_of_rank_; //!< node of each rank
};

} // namespace demens::dem
