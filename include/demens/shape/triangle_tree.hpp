#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>
#include <vector>

namespace demens::shape {

//! A box along the axes.
struct Bounds
{
    Vector3 lower, upper; //!< [m]

    void include(Vector3 const& p);
    //! Square of the distance of a point [m^2]; 0 inside.
    DEMENS_FUNCTION double distance_squared(Vector3 const& p) const
    {
        double const dx = p.x < lower.x ? lower.x - p.x : p.x > upper.x ? p.x - upper.x : 0;
        double const dy = p.y < lower.y ? lower.y - p.y : p.y > upper.y ? p.y - upper.y : 0;
        double const dz = p.z < lower.z ? lower.z - p.z : p.z > upper.z ? p.z - upper.z : 0;
        return dx * dx + dy * dy + dz * dz;
    }
};

//! Part of a tree of triangles.
struct TreeNode
{
    Bounds bounds;
    std::uint32_t first;     //!< of its triangles in the order, or the first of its two children
    std::uint32_t triangles; //!< 0: has children
};

//! A tree that lies somewhere, on the host or on a device; no nodes: nothing in it.
struct TreeView
{
    TreeNode const* nodes;      //!< the first one has all triangles
    std::uint32_t const* order; //!< numbers of triangles, those of a node one after another

    //! Calls visit(triangle) for each triangle whose bounds are nearer than `reach` [m], in a fixed order.
    DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES
    template <class Visit>
    DEMENS_FUNCTION void for_each_near(Vector3 const& point, double reach, Visit&& visit) const
    {
        std::uint32_t open[64]; // a balanced tree of 2^32 triangles is 32 deep
        int count = 0;
        if (nodes != nullptr)
            open[count++] = 0;
        while (count > 0) {
            TreeNode const& node = nodes[open[--count]];
            if (node.bounds.distance_squared(point) >= reach * reach)
                continue;
            if (node.triangles > 0) {
                for (std::uint32_t k = 0; k < node.triangles; ++k)
                    visit(order[node.first + k]);
            } else {
                open[count++] = node.first + 1;
                open[count++] = node.first;
            }
        }
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
        view().for_each_near(point, reach, visit);
    }

    std::vector<TreeNode> const& nodes() const { return nodes_; }
    std::vector<std::uint32_t> const& order() const { return order_; }

  private:
    TreeView view() const { return {nodes_.empty() ? nullptr : nodes_.data(), order_.data()}; }
    void split(std::uint32_t node, std::uint32_t from, std::uint32_t to, std::vector<Bounds> const& bounds);

    std::vector<TreeNode> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace demens::shape
