#pragma once

#include "demens/base/random.hpp"
#include "demens/dem/wall.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace demens::test {

inline dem::Mesh mesh_of(shape::TriangleSoup const& soup)
{
    return {.mesh = std::make_shared<shape::TriangleMesh>(soup)};
}

//! The square from -half to half in the plane z = 0 as cells x cells pairs of triangles, whose inner corners
//! are moved about in the plane so that edges run in all directions.
inline shape::TriangleSoup plane_triangles(double half, int cells, std::uint64_t seed = 1)
{
    RandomStream random(seed);
    double const side = 2 * half / cells;
    std::vector<Vector3> corners;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            bool const inner = i > 0 && j > 0 && i < cells && j < cells;
            double const reach = inner ? 0.3 * side : 0;
            corners.push_back({-half + side * i + random.uniform(-reach, reach),
                               -half + side * j + random.uniform(-reach, reach), 0});
        }
    shape::TriangleSoup soup;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            int const row = cells + 1;
            Vector3 const a = corners[j * row + i], b = corners[j * row + i + 1],
                          c = corners[(j + 1) * row + i + 1], d = corners[(j + 1) * row + i];
            soup.push_back({a, b, c});
            soup.push_back({a, c, d});
        }
    return soup;
}

//! A drum along y, open at both ends: `around` facets of `along` pairs of triangles each.
inline shape::TriangleSoup drum_triangles(double radius, double half_length, int around, int along)
{
    auto const corner = [&](int i, int j) {
        double const angle = 2 * std::numbers::pi * (i % around) / around;
        return Vector3{radius * std::cos(angle), -half_length + 2 * half_length * j / along,
                       radius * std::sin(angle)};
    };
    shape::TriangleSoup soup;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            soup.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            soup.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    return soup;
}

} // namespace demens::test
