#include "demens/dem/neighbours.hpp"

#include "demens/base/error.hpp"
#include "demens/dem/wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

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
        std::swap(old_lists_[k].offset, lists[k].offset);
        lists[k].clear();
    }
    if (periods_.any())
        find_pairs<true>(particles, grid, skin, lists);
    else
        find_pairs<false>(particles, grid, skin, lists);
    find_wall_contacts(particles, walls, skin, lists);
    if (particles.ghosts > 0)
        find_ghost_pairs(particles, grid, skin, lists);
}

void NeighbourSearch::check_periods(double largest_radius, double skin) const
{
    double const reach = 2 * largest_radius + skin;
    for (auto const& [name, period] : {std::pair{"x", periods_.x}, std::pair{"y", periods_.y}})
        if (period.on() && period.length() < 2 * reach)
            throw InputError(
                fmt::format("the period of {} m along {} is too short: it must be at least {} m, twice the "
                            "largest diameter and the skin",
                            period.length(), name, 2 * reach));
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
    check_periods(largest, skin);
    double cell = std::max(2 * largest + skin, 1e-12);
    Vector3 extent = upper - lower;
    for (auto const& [period, from, size] :
         {std::tuple{&periods_.x, &lower.x, &extent.x}, std::tuple{&periods_.y, &lower.y, &extent.y}})
        if (period->on())
            *from = period->lower, *size = period->length();
    // A period holds whole cells.
    auto const cells_along = [&](double length, bool periodic) {
        return std::max(1.0, std::floor(length / cell) + !periodic);
    };
    auto const cells = [&] {
        return Vector3{cells_along(extent.x, periods_.x.on()), cells_along(extent.y, periods_.y.on()),
                       cells_along(extent.z, false)};
    };
    // Far-flung particles must not make a huge empty grid: larger cells find the same pairs.
    double const most = 8.0 * static_cast<double>(particles.size()) + 4096;
    Vector3 n = cells();
    for (; n.x * n.y * n.z > most; n = cells())
        cell *= 1.5;
    return {
        lower,
        {periods_.x.on() ? n.x / extent.x : 1 / cell, periods_.y.on() ? n.y / extent.y : 1 / cell, 1 / cell},
        static_cast<int>(n.x),
        static_cast<int>(n.y),
        static_cast<int>(n.z)};
}

void NeighbourSearch::sort_into_cells(Particles& particles, Grid const& grid)
{
    std::size_t const n = particles.size();
    cell_of_.resize(n);
    new_index_.resize(n);
    number_along_cells(particles, grid, 0, particles.owned(), cell_start_);
    if (particles.ghosts > 0)
        number_along_cells(particles, grid, particles.owned(), n, ghost_cell_start_);

    sorted_.resize(n);
    sorted_.ghosts = particles.ghosts;
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

void NeighbourSearch::number_along_cells(Particles const& particles, Grid const& grid, std::size_t from,
                                         std::size_t to, std::vector<std::uint32_t>& cell_start)
{
    std::size_t const cells = static_cast<std::size_t>(grid.nx) * grid.ny * grid.nz;
    cell_start.assign(cells + 1, 0);
    cell_start[0] = static_cast<std::uint32_t>(from);
    auto const along = [](double offset, double per_length, int count) {
        return std::min(static_cast<int>(offset * per_length), count - 1);
    };
    for (std::size_t i = from; i < to; ++i) {
        Place const& p = particles.place[i];
        int const cx = along(p.x - grid.lower.x, grid.per_length.x, grid.nx);
        int const cy = along(p.y - grid.lower.y, grid.per_length.y, grid.ny);
        int const cz = along(p.z - grid.lower.z, grid.per_length.z, grid.nz);
        cell_of_[i] = static_cast<std::uint32_t>((cz * grid.ny + cy) * grid.nx + cx);
        ++cell_start[cell_of_[i] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c)
        cell_start[c + 1] += cell_start[c];
    std::vector<std::uint32_t> next(cell_start.begin(), cell_start.end() - 1);
    for (std::size_t i = from; i < to; ++i)
        new_index_[i] = next[cell_of_[i]]++;
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
    restore_histories(list, list.size() - 1);
}

void NeighbourSearch::add_patch(ContactList& list, std::uint32_t i, std::uint32_t wall,
                                std::span<NearTriangle const> triangles)
{
    auto const slot = static_cast<std::uint32_t>(list.size());
    auto const count = static_cast<std::uint32_t>(triangles.size());
    list.patches.push_back({slot, std::min(count, MeshPatch::most_contacts),
                            static_cast<std::uint32_t>(list.near_triangles.size()), count,
                            MeshPatch::always});
    list.near_triangles.insert(list.near_triangles.end(), triangles.begin(), triangles.end());
    for (std::uint32_t k = 0; k < list.patches.back().slots; ++k)
        list.add(i, wall);
    restore_histories(list, slot);
}

void NeighbourSearch::restore_histories(ContactList& list, std::size_t slot)
{
    // A ghost may come first in its pair; contacts are filed under the other one.
    bool const reversed = list.with_ghost && list.second[slot] < list.first[slot];
    std::uint32_t const i = reversed ? list.second[slot] : list.first[slot];
    std::uint32_t const j = reversed ? list.first[slot] : list.second[slot];
    auto const size = static_cast<std::size_t>(list.state_size);
    for (std::uint32_t k = old_start_[i]; k < old_start_[i + 1] && slot < list.size(); ++k) {
        OldContact const& old = old_contacts_[k];
        if (old.other != j || old.with_wall != list.with_wall)
            continue;
        list.touching[slot] = 1;
        ContactList const& from_list = old_lists_[old.list];
        double const* from = from_list.state.data() + old.slot * size;
        double* to = list.state.data() + slot * size;
        for (int c = 0; c < list.state_size; ++c)
            to[c] = old.reversed != reversed && c >= list.state_scalars ? -from[c] : from[c];
        if (list.with_wall)
            list.offset[slot] = from_list.offset[old.slot];
        ++slot;
    }
}

//! The own cell comes first, without a range: the rest of it and the cell after it belong to the own row.
//! Cells along x follow one another, so a row of three cells is one range; across a periodic border it is
//! two.
NeighbourSearch::ForwardCells NeighbourSearch::forward_cells(Grid const& grid, int cx, int cy, int cz) const
{
    ForwardCells forward;
    bool const wraps_x = periods_.x.on() && grid.nx > 2;
    auto const row_start = [&](int y, int z) { return (z * grid.ny + y) * grid.nx; };
    if (wraps_x && cx == grid.nx - 1)
        forward.add(row_start(cy, cz), row_start(cy, cz));
    constexpr int rows[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}}; // (dy, dz)
    for (auto const& [dy, dz] : rows) {
        int y = cy + dy;
        int const z = cz + dz;
        if (periods_.y.on()) {
            // With one or two rows in the period, up and down lead to the same row.
            if ((grid.ny == 1 && dy != 0) || (grid.ny == 2 && (dy < 0 || (dz == 0 && cy == 1))))
                continue;
            y = (y + grid.ny) % grid.ny;
        }
        if (y < 0 || y >= grid.ny || z >= grid.nz)
            continue;
        int const row = row_start(y, z);
        forward.add(row + std::max(cx - 1, 0), row + std::min(cx + 1, grid.nx - 1));
        if (wraps_x && cx == 0)
            forward.add(row + grid.nx - 1, row + grid.nx - 1);
        if (wraps_x && cx == grid.nx - 1)
            forward.add(row, row);
    }
    return forward;
}

template <bool periodic>
void NeighbourSearch::find_pairs(Particles const& particles, Grid const& grid, double skin,
                                 std::vector<ContactList>& lists)
{
    double const length_x = periods_.x.length(), length_y = periods_.y.length();
    double const half_x = periods_.x.half(), half_y = periods_.y.half();
    auto const test_range = [&](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
        Place const a = particles.place[i];
        std::uint32_t const* row = interaction_.data() + particles.material[i] * materials_;
        for (std::uint32_t j = from; j < to; ++j) {
            Place const& b = particles.place[j];
            double dx = a.x - b.x, dy = a.y - b.y;
            double const dz = a.z - b.z;
            if constexpr (periodic) {
                dx = nearest_image(dx, length_x, half_x);
                dy = nearest_image(dy, length_y, half_y);
            }
            double const reach = a.radius + b.radius + skin;
            if (dx * dx + dy * dy + dz * dz >= reach * reach)
                continue;
            // Across a border a neighbour may come earlier in the order, as histories are filed.
            if (periodic && j < i)
                add_pair(lists[interaction_[particles.material[j] * materials_ + particles.material[i]]], j,
                         i);
            else
                add_pair(lists[row[particles.material[j]]], i, j);
        }
    };
    std::uint32_t i = 0;
    for (int cz = 0; cz < grid.nz; ++cz)
        for (int cy = 0; cy < grid.ny; ++cy)
            for (int cx = 0; cx < grid.nx; ++cx) {
                int const cell = (cz * grid.ny + cy) * grid.nx + cx;
                std::uint32_t const end = cell_start_[cell + 1];
                if (i == end)
                    continue;
                std::uint32_t const own_row_end = cell_start_[cell + (cx + 1 < grid.nx ? 2 : 1)];
                ForwardCells const forward = forward_cells(grid, cx, cy, cz);
                for (; i < end; ++i) {
                    test_range(i, i + 1, own_row_end);
                    for (int r = 0; r < forward.count; ++r)
                        test_range(i, cell_start_[forward.from[r]], cell_start_[forward.to[r]]);
                }
            }
}

void NeighbourSearch::find_wall_contacts(Particles const& particles, std::vector<Wall> const& walls,
                                         double skin, std::vector<ContactList>& lists)
{
    auto const pair_lists = static_cast<std::size_t>(
        std::find_if(lists.begin(), lists.end(), [](auto const& list) { return list.with_wall; }) -
        lists.begin());
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
        Wall const& wall = walls[w];
        if (!wall.active)
            continue;
        WallNeighbours const found = find_neighbours(wall, particles, skin);
        bool const is_mesh = std::holds_alternative<Mesh>(wall.shape);
        for (std::size_t k = 0; k < found.particles.size(); ++k) {
            std::uint32_t const i = found.particles[k];
            auto& list = lists[pair_lists + interaction_[particles.material[i] * materials_ + wall.material]];
            if (is_mesh)
                add_patch(list, i, w,
                          {found.near_triangles.data() + found.triangle_start[k],
                           found.triangle_start[k + 1] - found.triangle_start[k]});
            else
                add_pair(list, i, w);
        }
    }
}

} // namespace demens::dem
