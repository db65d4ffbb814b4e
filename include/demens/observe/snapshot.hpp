#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace demens::observe {

//! What the numbers of a snapshot stand for.
struct SnapshotNames
{
    std::vector<std::string> materials = {}, groups = {}, walls = {};
};

//! Particles at one moment, for pictures and files.
struct Snapshot
{
    std::string name;                                         //!< "settled", "final", ...
    double time = 0;                                          //!< [s]
    std::vector<double> x, y, z, radius;                      //!< [m]
    std::vector<double> vx, vy, vz;                           //!< [m/s]; empty where they were not kept
    std::vector<double> wx, wy, wz;                           //!< [rad/s]; empty where they were not kept
    std::vector<double> fx = {}, fy = {}, fz = {}, mass = {}; //!< [N], [kg]; for frames, else empty
    std::vector<std::uint32_t> material = {};                 //!< its number; for frames, else empty
    std::vector<std::uint32_t> id = {}; //!< stays with a particle; for frames, else empty
    //! Number of the grain of each, where grains are made of several spheres; for frames, not kept in a
    //! campaign file.
    std::vector<std::int64_t> grain = {};
    //! What each is of a grain that is a hull: nothing; one that fills it; else one more than the number of
    //! the hull whose corner it is, with the rounding as its radius. Empty where there are none.
    std::vector<std::uint32_t> hull = {};
    static constexpr std::uint32_t no_hull = 0, within_a_hull = 0xffffffff;
    std::vector<std::array<double, 6>> walls; //!< axis-aligned wall outlines (x0, y0, z0, x1, y1, z1) [m]
    //! Rims and creases of other walls, from (x0, y0, z0) to (x1, y1, z1) [m].
    std::vector<std::array<double, 6>> wall_lines = {};
    //! Surfaces of other walls, three corners each [m]; for frames, not kept in a campaign file.
    std::vector<std::array<double, 9>> wall_triangles = {};
    // For frames, else empty:
    std::vector<std::int64_t> group = {}; //!< number of each particle's; -1: none
    std::vector<std::int64_t> wall_of_box = {}, wall_of_triangle = {}; //!< numbers of walls
    SnapshotNames names = {};
};

} // namespace demens::observe
