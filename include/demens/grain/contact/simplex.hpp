#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>

namespace demens::grain {

//! Up to four differences of vertices of two cores, and how the point nearest to the origin is made of them.
struct Simplex
{
    struct Corner
    {
        Vector3 difference;         //!< vertex of the first minus vertex of the second [m]
        std::uint16_t a = 0, b = 0; //!< their numbers
        double part = 0;            //!< of the nearest point; all together are 1
    };
    Corner corners[4];
    int size = 0;
    Vector3 nearest; //!< to the origin [m]

    DEMENS_INLINE DEMENS_FUNCTION bool has(std::uint16_t a, std::uint16_t b) const
    {
        for (int k = 0; k < size; ++k)
            if (corners[k].a == a && corners[k].b == b)
                return true;
        return false;
    }
    //! Finds the nearest point and keeps the corners that it is made of. False where the origin is inside.
    DEMENS_FUNCTION bool reduce();

  private:
    //! The nearest point on up to three corners, which are kept as bits.
    struct Nearest
    {
        Vector3 point;
        double squared;
        double parts[4];
        unsigned kept;
    };
    DEMENS_INLINE DEMENS_FUNCTION void consider_edge(Nearest& best, int i, int j) const;
    DEMENS_FUNCTION void consider_triangle(Nearest& best, int i, int j, int k) const;
};

DEMENS_FUNCTION inline void Simplex::consider_edge(Nearest& best, int i, int j) const
{
    Vector3 const &a = corners[i].difference, &b = corners[j].difference;
    Vector3 const side = b - a;
    double const length = norm_squared(side), along = -dot(a, side);
    double const t = along <= 0 ? 0 : along >= length ? 1 : along / length;
    Vector3 const point = t == 1 ? b : a + t * side;
    double const squared = norm_squared(point);
    if (squared < best.squared) {
        best = {point, squared, {0, 0, 0, 0}, (t < 1 ? 1U << i : 0U) | (t > 0 ? 1U << j : 0U)};
        best.parts[i] = 1 - t;
        best.parts[j] = t;
    }
}

DEMENS_FUNCTION inline void Simplex::consider_triangle(Nearest& best, int i, int j, int k) const
{
    Vector3 const &a = corners[i].difference, &b = corners[j].difference, &c = corners[k].difference;
    Vector3 const ab = b - a, ac = c - a, normal = cross(ab, ac);
    double const area = norm_squared(normal); // the square of twice the area
    // Parts of the origin's foot: areas of the triangles that it makes with each side.
    double const pa = dot(normal, cross(b, c)), pb = dot(normal, cross(c, a)), pc = dot(normal, cross(a, b));
    if (pa > 0 && pb > 0 && pc > 0 && area > 1e-24 * norm_squared(ab) * norm_squared(ac)) {
        Vector3 const point = (dot(normal, a) / area) * normal;
        double const squared = norm_squared(point);
        if (squared < best.squared) {
            double const sum = 1 / (pa + pb + pc);
            best = {point, squared, {0, 0, 0, 0}, 1U << i | 1U << j | 1U << k};
            best.parts[i] = pa * sum;
            best.parts[j] = pb * sum;
            best.parts[k] = pc * sum;
        }
        return;
    }
    // The nearest point is on a side that the foot lies beyond; all of them in a triangle without an area.
    bool const flat = !(pa > 0 || pb > 0 || pc > 0);
    if (flat || pc <= 0)
        consider_edge(best, i, j);
    if (flat || pb <= 0)
        consider_edge(best, i, k);
    if (flat || pa <= 0)
        consider_edge(best, j, k);
    if (!flat && pa > 0 && pb > 0 && pc > 0) { // thin beyond trust
        consider_edge(best, i, j);
        consider_edge(best, i, k);
        consider_edge(best, j, k);
    }
}

DEMENS_FUNCTION inline bool Simplex::reduce()
{
    Nearest best{{}, 1e300, {0, 0, 0, 0}, 0};
    if (size == 1) {
        best = {corners[0].difference, 0, {1, 0, 0, 0}, 1};
    } else if (size == 2) {
        consider_edge(best, 0, 1);
    } else if (size == 3) {
        consider_triangle(best, 0, 1, 2);
    } else {
        // A face may hold the nearest point if the origin is on its far side from the fourth corner.
        constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
        bool outside = false;
        for (auto const& [i, j, k, other] : faces) {
            Vector3 const& a = corners[i].difference;
            Vector3 const normal = cross(corners[j].difference - a, corners[k].difference - a);
            double const origin = -dot(normal, a), fourth = dot(normal, corners[other].difference - a);
            double const little =
                1e-12 * std::sqrt(norm_squared(normal) * norm_squared(corners[other].difference - a));
            if (origin * fourth < 0 || std::abs(fourth) <= little) {
                consider_triangle(best, i, j, k);
                outside = true;
            }
        }
        if (!outside)
            return false;
    }
    nearest = best.point;
    int kept = 0;
    for (int k = 0; k < size; ++k)
        if (best.kept >> k & 1U) {
            corners[kept] = corners[k];
            corners[kept++].part = best.parts[k];
        }
    size = kept;
    return true;
}

} // namespace demens::grain
