#include "demens/shape/triangle_tree.hpp"

#include <algorithm>
#include <numeric>

namespace demens::shape {

void Bounds::include(Vector3 const& p)
{
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
}

TriangleTree::TriangleTree(std::vector<Bounds> const& triangles) : order_(triangles.size())
{
    if (triangles.empty())
        return;
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.push_back({});
    split(0, 0, static_cast<std::uint32_t>(triangles.size()), triangles);
}

//! Halves the triangles [from, to) of the order at the median of their middles along the longest axis.
void TriangleTree::split(std::uint32_t node, std::uint32_t from, std::uint32_t to,
                         std::vector<Bounds> const& bounds)
{
    constexpr std::uint32_t leaf_size = 4;
    auto const twice_middle = [&](std::uint32_t k) { return bounds[k].lower + bounds[k].upper; };
    Bounds all = bounds[order_[from]], middles{twice_middle(order_[from]), twice_middle(order_[from])};
    for (std::uint32_t k = from + 1; k < to; ++k) {
        all.include(bounds[order_[k]].lower);
        all.include(bounds[order_[k]].upper);
        middles.include(twice_middle(order_[k]));
    }
    if (to - from <= leaf_size) {
        nodes_[node] = {all, from, to - from};
        return;
    }
    Vector3 const size = middles.upper - middles.lower;
    double Vector3::*const along = size.x >= size.y && size.x >= size.z ? &Vector3::x
                                   : size.y >= size.z                   ? &Vector3::y
                                                                        : &Vector3::z;
    std::uint32_t const middle = from + (to - from) / 2;
    std::nth_element(
        order_.begin() + from, order_.begin() + middle, order_.begin() + to,
        [&](std::uint32_t a, std::uint32_t b) { return twice_middle(a).*along < twice_middle(b).*along; });
    auto const children = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node] = {all, children, 0};
    split(children, from, middle, bounds);
    split(children + 1, middle, to, bounds);
}

} // namespace demens::shape
