#include "demens/dem/neighbours.hpp"

#include "demens/dem/wall_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace demens::dem {

void NeighbourSearch::rebuild(Particles& particles, std::vector<Wall> const& walls, double skin,
                              std::vector<ContactList>& lists)
{
    Grid const grid = make_grid(particles, skin);
    sort_into_cells(particles, grid);
    index_old_contacts(particles.size(), lists);
    old_lists_.resize(lists.size());
    for (std::size_t k = 0; k < lists.size(); ++k) {
        std::swap(old_lists_[k].state, lists[k].state);
        lists[k].clear();
    }
    find_pairs(particles, grid, skin, lists);
    find_wall_contacts(particles, walls, skin, lists);
}

NeighbourSearch::Grid NeighbourSearch::make_grid(Particles const& particles, double skin) const
{
    Vector3 lower{0, 0, 0}, upper{0, 0, 0};
    double largest = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        Place const& p = particles.place[i];
        if (i == 0)
            lower = upper = {p.x, p.y, p.z};
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
        largest = std::max(largest, p.radius);
    }
    double cell = std::max(2 * largest + skin, 1e-12);
    auto const cells_along = [&](double extent) { return 1 + std::floor(extent / cell); };
    // Far-flung particles must not make a huge empty grid: larger cells find the same pairs.
    double const most = 8.0 * static_cast<double>(particles.size()) + 4096;
    while (cells_along(upper.x - lower.x) * cells_along(upper.y - lower.y) * cells_along(upper.z - lower.z) >
           most)
        cell *= 1.5;
    return {lower, 1 / cell, static_cast<int>(cells_along(upper.x - lower.x)),
            static_cast<int>(cells_along(upper.y - lower.y)),
            static_cast<int>(cells_along(upper.z - lower.z))};
}

void NeighbourSearch::sort_into_cells(Particles& particles, Grid const& grid)
{
    std::size_t const n = particles.size();
    std::size_t const cells = static_cast<std::size_t>(grid.nx) * grid.ny * grid.nz;
    cell_of_.resize(n);
    cell_start_.assign(cells + 1, 0);
    auto const along = [&](double offset, int count) {
        return std::min(static_cast<int>(offset * grid.inverse_cell), count - 1);
    };
    for (std::size_t i = 0; i < n; ++i) {
        Place const& p = particles.place[i];
        int const cx = along(p.x - grid.lower.x, grid.nx);
        int const cy = along(p.y - grid.lower.y, grid.ny);
        int const cz = along(p.z - grid.lower.z, grid.nz);
        cell_of_[i] = static_cast<std::uint32_t>((cz * grid.ny + cy) * grid.nx + cx);
        ++cell_start_[cell_of_[i] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c)
        cell_start_[c + 1] += cell_start_[c];

    new_index_.resize(n);
    std::vector<std::uint32_t> next(cell_start_.begin(), cell_start_.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
        new_index_[i] = next[cell_of_[i]]++;

    sorted_.place.resize(n), sorted_.motion.resize(n), sorted_.load.resize(n);
    sorted_.material.resize(n), sorted_.id.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        std::uint32_t const to = new_index_[i];
        sorted_.place[to] = particles.place[i];
        sorted_.motion[to] = particles.motion[i];
        sorted_.load[to] = particles.load[i];
        sorted_.material[to] = particles.material[i];
        sorted_.id[to] = particles.id[i];
    }
    std::swap(particles, sorted_);
}

void NeighbourSearch::index_old_contacts(std::size_t particles, std::vector<ContactList> const& lists)
{
    // Every touching contact is filed under the particle that will come first in its pair; wall contacts
    // under the particle.
    old_start_.assign(particles + 1, 0);
    auto const for_each_touching = [&](auto&& visit) {
        for (std::uint32_t k = 0; k < lists.size(); ++k)
            for (std::uint32_t s = 0; s < lists[k].size(); ++s) {
                if (!lists[k].touching[s])
                    continue;
                std::uint32_t const i = new_index_[lists[k].first[s]];
                bool const wall = lists[k].with_wall;
                std::uint32_t const j = wall ? lists[k].second[s] : new_index_[lists[k].second[s]];
                bool const reversed = !wall && j < i;
                visit(reversed ? j : i, OldContact{reversed ? i : j, k, s, wall, reversed});
            }
    };
    for_each_touching([&](std::uint32_t owner, OldContact const&) { ++old_start_[owner + 1]; });
    for (std::size_t i = 0; i < particles; ++i)
        old_start_[i + 1] += old_start_[i];
    old_contacts_.resize(old_start_[particles]);
    std::vector<std::uint32_t> next(old_start_.begin(), old_start_.end() - 1);
    for_each_touching(
        [&](std::uint32_t owner, OldContact const& contact) { old_contacts_[next[owner]++] = contact; });
}

void NeighbourSearch::add_pair(ContactList& list, std::uint32_t i, std::uint32_t j)
{
    list.add(i, j);
    for (std::uint32_t k = old_start_[i]; k < old_start_[i + 1]; ++k) {
        OldContact const& old = old_contacts_[k];
        if (old.other != j || old.with_wall != list.with_wall)
            continue;
        list.touching.back() = 1;
        auto const size = static_cast<std::size_t>(list.state_size);
        double const* from = old_lists_[old.list].state.data() + old.slot * size;
        double* to = list.state.data() + (list.size() - 1) * size;
        for (int c = 0; c < list.state_size; ++c)
            to[c] = old.reversed && c >= list.state_scalars ? -from[c] : from[c];
        return;
    }
}

void NeighbourSearch::find_pairs(Particles const& particles, Grid const& grid, double skin,
                                 std::vector<ContactList>& lists)
{
    auto const test_range = [&](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
        Place const a = particles.place[i];
        std::uint32_t const* row = interaction_.data() + particles.material[i] * materials_;
        for (std::uint32_t j = from; j < to; ++j) {
            Place const& b = particles.place[j];
            double const dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
            double const reach = a.radius + b.radius + skin;
            if (dx * dx + dy * dy + dz * dz < reach * reach)
                add_pair(lists[row[particles.material[j]]], i, j);
        }
    };
    // Cells along x follow one another, so a row of three cells is one range of particles. The forward half
    // of the neighbourhood is the rest of the own row and four more rows.
    std::uint32_t i = 0;
    for (int cz = 0; cz < grid.nz; ++cz)
        for (int cy = 0; cy < grid.ny; ++cy)
            for (int cx = 0; cx < grid.nx; ++cx) {
                int const cell = (cz * grid.ny + cy) * grid.nx + cx;
                std::uint32_t const end = cell_start_[cell + 1];
                if (i == end)
                    continue;
                std::uint32_t const own_row_end = cell_start_[cell + (cx + 1 < grid.nx ? 2 : 1)];
                std::uint32_t range_from[4], range_to[4];
                int ranges = 0;
                constexpr int forward[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}}; // (dy, dz)
                for (auto const& [dy, dz] : forward) {
                    int const y = cy + dy, z = cz + dz;
                    if (y < 0 || y >= grid.ny || z >= grid.nz)
                        continue;
                    int const row = (z * grid.ny + y) * grid.nx;
                    range_from[ranges] = cell_start_[row + std::max(cx - 1, 0)];
                    range_to[ranges++] = cell_start_[row + std::min(cx + 1, grid.nx - 1) + 1];
                }
                for (; i < end; ++i) {
                    test_range(i, i + 1, own_row_end);
                    for (int r = 0; r < ranges; ++r)
                        test_range(i, range_from[r], range_to[r]);
                }
            }
}

void NeighbourSearch::find_wall_contacts(Particles const& particles, std::vector<Wall> const& walls,
                                         double skin, std::vector<ContactList>& lists)
{
    std::size_t const pair_lists = lists.size() / 2;
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
        Wall const& wall = walls[w];
        if (!wall.active)
            continue;
        for (std::uint32_t const i : particles_near(wall, particles, skin))
            add_pair(lists[pair_lists + interaction_[particles.material[i] * materials_ + wall.material]], i,
                     w);
    }
}

} // namespace demens::dem
