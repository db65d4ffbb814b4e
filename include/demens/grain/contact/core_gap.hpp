#pragma once

#include "demens/grain/contact/core.hpp"
#include "demens/grain/contact/feature_contact.hpp"
#include "demens/grain/contact/simplex.hpp"

namespace demens::grain {

//! What a pair remembers from one step to the next: where to begin. The result depends on it within rounding,
//! so that it belongs to the state that a run is continued from.
struct PairMemory
{
    std::uint16_t a[3] = {}, b[3] = {}; //!< vertices of the last simplex
    std::uint16_t size = 0;             //!< how many of them; 0: nothing is remembered
    std::uint16_t was_near = 0;         //!< whether they were within reach
    float normal[3] = {};               //!< from the first to the second, in the first one's axes
};

//! The gap between two cores, in the axes and from the place of the first.
struct CoreGap
{
    CoreState state = CoreState::apart;
    double gap = 0; //!< [m]; negative: how far they must move apart along the normal; `apart`: it is no less
    Vector3 normal; //!< unit, from the first to the second
    Vector3 on_a, on_b;                     //!< nearest points [m]
    std::uint16_t vertex_a[3], vertex_b[3]; //!< the vertices between which these lie
    int size = 0;                           //!< how many pairs of them
};

namespace detail {

//! The pair of vertices farthest from each other along a direction, as a corner.
DEMENS_INLINE DEMENS_FUNCTION Simplex::Corner corner_along(CorePair const& pair, Vector3 const& normal,
                                                           std::uint16_t from_a, std::uint16_t from_b)
{
    std::uint16_t const a = pair.farthest_a(normal, from_a), b = pair.nearest_b(normal, from_b);
    return {pair.vertex_a(a) - pair.vertex_b(b), a, b, 1};
}

//! Cores that overlap: their overlap along the last known normal, or the line between their places.
DEMENS_FUNCTION inline CoreGap overlap_along_last(CorePair const& pair, PairMemory const& memory)
{
    Vector3 normal{memory.normal[0], memory.normal[1], memory.normal[2]};
    if (norm_squared(normal) == 0)
        normal = norm_squared(pair.shift) > 0 ? pair.shift : Vector3{0, 0, 1};
    normal = normal / norm(normal);
    Simplex::Corner const corner = corner_along(pair, normal, memory.a[0], memory.b[0]);
    CoreGap result;
    result.state = CoreState::overlapping;
    result.gap = -dot(corner.difference, normal);
    result.normal = normal;
    result.on_a = pair.vertex_a(corner.a);
    result.on_b = pair.vertex_b(corner.b);
    result.vertex_a[0] = corner.a;
    result.vertex_b[0] = corner.b;
    result.size = 1;
    return result;
}

DEMENS_INLINE DEMENS_FUNCTION void remember_normal(PairMemory& memory, Vector3 const& normal)
{
    memory.normal[0] = static_cast<float>(normal.x);
    memory.normal[1] = static_cast<float>(normal.y);
    memory.normal[2] = static_cast<float>(normal.z);
}

//! The gap of cores that are near, if the three pairs of vertices of the last step still tell their nearest
//! points: what `core_gap` finds then, sooner. False if they do not.
DEMENS_INLINE DEMENS_FUNCTION bool gap_as_before(CorePair const& pair, double reach, PairMemory& memory,
                                                 CoreGap& result)
{
    Vector3 const a0 = pair.vertex_a(memory.a[0]), a1 = pair.vertex_a(memory.a[1]);
    Vector3 const a2 = pair.vertex_a(memory.a[2]), b0 = pair.vertex_b(memory.b[0]);
    Vector3 const b1 = pair.vertex_b(memory.b[1]), b2 = pair.vertex_b(memory.b[2]);
    Vector3 const d0 = a0 - b0, d1 = a1 - b1, d2 = a2 - b2;
    Vector3 const side = d1 - d0, other = d2 - d0, across = cross(side, other);
    double const area = norm_squared(across);
    double const p0 = dot(across, cross(d1, d2)), p1 = dot(across, cross(d2, d0));
    double const p2 = dot(across, cross(d0, d1)), height = dot(across, d0);
    if (!(p0 > 0 && p1 > 0 && p2 > 0 && area > 1e-24 * norm_squared(side) * norm_squared(other) &&
          height * height < reach * reach * area && height * height > 1e-20 * reach * reach * area))
        return false;
    double const per_length = 1 / std::sqrt(area), distance = std::abs(height) * per_length;
    Vector3 const normal = (height > 0 ? -per_length : per_length) * across;
    std::uint16_t const a = pair.farthest_a(normal, memory.a[0]), b = pair.nearest_b(normal, memory.b[0]);
    bool const is_known = (a == memory.a[0] && b == memory.b[0]) || (a == memory.a[1] && b == memory.b[1]) ||
                          (a == memory.a[2] && b == memory.b[2]);
    if (!is_known && distance + dot(pair.vertex_a(a) - pair.vertex_b(b), normal) > 1e-14 * distance)
        return false;
    double const sum = 1 / (p0 + p1 + p2), c0 = sum * p0, c1 = sum * p1, c2 = sum * p2;
    result.state = CoreState::near;
    result.gap = distance;
    result.normal = normal;
    result.on_a = c0 * a0 + c1 * a1 + c2 * a2;
    result.on_b = c0 * b0 + c1 * b1 + c2 * b2;
    for (int k = 0; k < 3; ++k)
        result.vertex_a[k] = memory.a[k], result.vertex_b[k] = memory.b[k];
    result.size = 3;
    remember_normal(memory, normal);
    return true;
}

} // namespace detail

//! The distance of two cores if it is below `reach` [m], after Gilbert, Johnson & Keerthi (1988), from where
//! the pair was left. A direction in which the cores are farther apart than `reach` ends it at once, that of
//! the last step first. It converges when the farthest pair of vertices along the normal is one that it knows
//! or adds nothing.
DEMENS_FUNCTION inline CoreGap core_gap(CorePair const& pair, double reach, PairMemory& memory)
{
    using namespace detail;
    CoreGap result;
    if (memory.was_near && memory.size == 3 && gap_as_before(pair, reach, memory, result))
        return result;
    Simplex simplex;
    for (int k = 0; k < memory.size; ++k)
        simplex.corners[k] = {pair.vertex_a(memory.a[k]) - pair.vertex_b(memory.b[k]), memory.a[k],
                              memory.b[k], 0};
    simplex.size = memory.size;
    Simplex::Corner next;
    if (!memory.was_near) {
        Vector3 const last = memory.size > 0 ? Vector3{memory.normal[0], memory.normal[1], memory.normal[2]}
                             : norm_squared(pair.shift) > 0 ? pair.shift
                                                            : Vector3{0, 0, 1};
        next = corner_along(pair, last, memory.a[0], memory.b[0]);
        double const gap = -dot(next.difference, last);
        if (gap > 0 && gap * gap > reach * reach * norm_squared(last)) {
            if (memory.size == 0)
                remember_normal(memory, last / norm(last));
            memory.size = 1;
            memory.a[0] = next.a, memory.b[0] = next.b;
            result.gap = gap / norm(last);
            return result;
        }
        if (!simplex.has(next.a, next.b))
            simplex.corners[simplex.size++] = next;
    }
    Simplex best; // the nearest so far
    double before = 1e300;
    double const zero = 1e-20 * reach * reach;
    constexpr int most = 64; // ten are many
    for (int k = 0; k < most; ++k) {
        if (!simplex.reduce() || norm_squared(simplex.nearest) <= zero)
            return overlap_along_last(pair, memory);
        double const squared = norm_squared(simplex.nearest);
        if (squared >= before) { // rounding
            simplex = best;
            break;
        }
        before = squared;
        Vector3 const normal = -simplex.nearest;
        next = corner_along(pair, normal, simplex.corners[0].a, simplex.corners[0].b);
        double const bound = dot(next.difference, simplex.nearest); // the distance times a lower bound of it
        if (bound > 0 && bound * bound > reach * reach * squared) {
            memory.size = 1;
            memory.was_near = 0;
            memory.a[0] = next.a, memory.b[0] = next.b;
            double const distance = std::sqrt(squared);
            remember_normal(memory, normal / distance);
            result.gap = bound / distance;
            return result;
        }
        if (squared - bound <= 1e-14 * squared || simplex.has(next.a, next.b))
            break;
        best = simplex;
        simplex.corners[simplex.size++] = next;
    }
    double const distance = norm(simplex.nearest);
    result.gap = distance;
    result.state = distance > reach ? CoreState::apart : CoreState::near;
    result.normal = -simplex.nearest / distance;
    for (int k = 0; k < simplex.size; ++k) {
        auto const& corner = simplex.corners[k];
        result.on_a += corner.part * pair.vertex_a(corner.a);
        result.on_b += corner.part * pair.vertex_b(corner.b);
        result.vertex_a[k] = memory.a[k] = corner.a;
        result.vertex_b[k] = memory.b[k] = corner.b;
    }
    result.size = simplex.size;
    memory.size = static_cast<std::uint16_t>(simplex.size);
    memory.was_near = result.state == CoreState::near;
    remember_normal(memory, result.normal);
    return result;
}

} // namespace demens::grain
