// The part of the neighbour search that deals with ghosts.
#include "demens/dem/neighbours.hpp"

#include <algorithm>

namespace demens::dem {

NeighbourSearch::CellsAround NeighbourSearch::cells_around(Grid const& grid, std::uint32_t cell) const
{
    CellsAround around;
    int const cx = static_cast<int>(cell) % grid.nx, row = static_cast<int>(cell) / grid.nx;
    int const cy = row % grid.ny, cz = row / grid.ny;
    bool const wraps_x = periods_.x.on() && grid.nx > 2;
    for (int z = std::max(cz - 1, 0); z <= std::min(cz + 1, grid.nz - 1); ++z)
        for (int dy = -1; dy <= 1; ++dy) {
            int y = cy + dy;
            if (periods_.y.on()) {
                // With one or two rows in the period, up and down lead to the same row.
                if ((grid.ny == 1 && dy != 0) || (grid.ny == 2 && dy < 0))
                    continue;
                y = (y + grid.ny) % grid.ny;
            }
            if (y < 0 || y >= grid.ny)
                continue;
            int const start = (z * grid.ny + y) * grid.nx;
            around.add(start + std::max(cx - 1, 0), start + std::min(cx + 1, grid.nx - 1));
            if (wraps_x && cx == 0)
                around.add(start + grid.nx - 1, start + grid.nx - 1);
            if (wraps_x && cx == grid.nx - 1)
                around.add(start, start);
        }
    return around;
}

//! All pairs of a ghost and a particle of this process. The one with the lower id comes first: the other
//! process has the same pair, and computes the same force from the same numbers.
void NeighbourSearch::find_ghost_pairs(Particles const& particles, Grid const& grid, double skin,
                                       std::vector<ContactList>& lists)
{
    auto const first_list = static_cast<std::size_t>(
        std::find_if(lists.begin(), lists.end(), [](auto const& list) { return list.with_ghost; }) -
        lists.begin());
    double const length_x = periods_.x.length(), length_y = periods_.y.length();
    double const half_x = periods_.x.half(), half_y = periods_.y.half();
    auto const add = [&](std::uint32_t i, std::uint32_t j) {
        add_pair(lists[first_list + interaction_[particles.material[i] * materials_ + particles.material[j]]],
                 i, j);
    };
    auto const owned = static_cast<std::uint32_t>(particles.owned());
    for (std::uint32_t c = 0; c + 1 < ghost_cell_start_.size(); ++c) {
        std::uint32_t const begin = ghost_cell_start_[c], end = ghost_cell_start_[c + 1];
        if (begin == end)
            continue;
        CellsAround const around = cells_around(grid, c);
        for (std::uint32_t ghost = std::max(begin, owned); ghost < end; ++ghost) {
            Place const a = particles.place[ghost];
            for (int r = 0; r < around.count; ++r)
                for (std::uint32_t j = cell_start_[around.from[r]]; j < cell_start_[around.to[r]]; ++j) {
                    Place const& b = particles.place[j];
                    double const dx = nearest_image(a.x - b.x, length_x, half_x);
                    double const dy = nearest_image(a.y - b.y, length_y, half_y), dz = a.z - b.z;
                    double const reach = a.radius + b.radius + skin;
                    if (dx * dx + dy * dy + dz * dz >= reach * reach)
                        continue;
                    if (particles.id[ghost] < particles.id[j])
                        add(ghost, j);
                    else
                        add(j, ghost);
                }
        }
    }
}

} // namespace demens::dem
