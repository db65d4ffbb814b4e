#pragma once

#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <utility>
#include <vector>

namespace demens::dem {

//! Particles that are nearer to a wall than their radius plus a reach, in ascending order.
struct WallNeighbours
{
    std::vector<std::uint32_t> particles;
    std::vector<NearTriangle> near_triangles;  //!< meshes: of all these particles
    std::vector<std::uint32_t> triangle_start; //!< meshes: first triangle of each, and the end
};
WallNeighbours find_neighbours(Wall const& wall, Particles const& particles, double reach);

//! Finds where the particles of a list of wall contacts touch, and stores the offsets. Compacts the slots
//! that touch or are within the laws' range, and those that touched before and no longer do, as the test of
//! pairs does. Returns both counts. `travelled` bounds how far any body moved since the rebuild [m].
std::pair<std::size_t, std::size_t> test_wall_contacts(ContactList& list, Particles const& particles,
                                                       std::vector<Wall> const& walls,
                                                       contact::Range const& range, double travelled,
                                                       std::uint32_t* now, std::uint32_t* parted);

} // namespace demens::dem
