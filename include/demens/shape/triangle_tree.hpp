#pragma once

#include "demens/base/vector3.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace demens::shape {

//! A box along the axes.
struct Bounds
{
    Vector3 lower, upper; //!< [m]

    void include(Vector3 const& p);
    //! Square of the distance of a point [m^2]; 0 inside.
    double distance_squared(Vector3 const& p) const
    {
        double const dx = p.x < lower.x ? lower.x - p.x : p.x > upper.x ? p.x - upper.x : 0;
        double const dy = p.y < lower.y ? lower.y - p.y : p.y > upper.y ? p.y - upper.y : 0;
        double const dz = p.z < lower.z ? lower.z - p.z : p.z > upper.z ? p.z - upper.z : 0;
        return dx * dx + dy * dy + dz * dz;
    }
};

//! Finds the triangles whose bounds are near a point: a binary tree of bounds.
class TriangleTree
{
  public:
    explicit TriangleTree(std::vector<Bounds> const& triangles);

    //! Calls visit(triangle) for each triangle whose bounds are nearer than `reach` [m], in a fixed order.
    template <class Visit>
    void for_each_near(Vector3 const& point, double reach, Visit&& visit) const
    {
        std::array<std::uint32_t, 64> open; // a balanced tree of 2^32 triangles is 32 deep
        int count = 0;
        if (!nodes_.empty())
            open[count++] = 0;
        while (count > 0) {
            Node const& node = nodes_[open[--count]];
            if (node.bounds.distance_squared(point) >= reach * reach)
                continue;
            if (node.triangles > 0) {
                for (std::uint32_t k = 0; k < node.triangles; ++k)
                    visit(order_[node.first + k]);
            } else {
                open[count++] = node.first + 1;
                open[count++] = node.first;
            }
        }
    }

  private:
    struct Node
    {
        Bounds bounds;
        std::uint32_t first;     //!< of its triangles in the order, or the first of its two children
        std::uint32_t triangles; //!< 0: has children
    };
    void split(std::uint32_t node, std::uint32_t from, std::uint32_t to, std::vector<Bounds> const& bounds);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace demens::shape
