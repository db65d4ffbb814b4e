#pragma once

#include "demens/contact/evaluation/stored_energy.hpp"
#include "src/dem/cuda/grid_kernels.hpp"
#include "src/dem/cuda/mesh_contacts.hpp"

namespace demens::dem::cuda {

//! Fills the lists of a particle, with the histories of contacts that go on.
struct FindNeighbours
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles)
            return;
        std::uint64_t const first = v.first_of(where.slot);
        Place const here = v.place[(1 - r.current) * v.all + first + where.local];
        find_pairs(r, where, first, here);
        find_walls(r, where, first, here);
    }

  private:
    //! Cells along one direction that may hold neighbours: they wrap around in a period.
    struct Span
    {
        int from, to, n;
        bool wraps;

        DEMENS_FUNCTION Span(int cell, int count, bool periodic) : from(cell - 1), to(cell + 1), n(count)
        {
            wraps = periodic;
            if (periodic) {
                from = count > 2 ? from : 0;
                to = count > 2 ? to : count - 1;
            } else {
                from = from < 0 ? 0 : from;
                to = to < count ? to : count - 1;
            }
        }
        DEMENS_FUNCTION int at(int k) const { return wraps ? (k + n) % n : k; }
    };

    DEMENS_FUNCTION void find_pairs(Replica& r, Where const& where, std::uint64_t first,
                                    Place const& here) const
    {
        std::uint64_t const i = first + where.local;
        std::uint32_t const now = 1 - r.sorted;
        std::uint32_t const* const start = v.cell_starts_of(where.slot);
        Place const* const places = v.place + (1 - r.current) * v.all + first;
        bool const wraps_x = r.periods.x.on(), wraps_y = r.periods.y.on();
        double const length_x = r.periods.x.length(), half_x = r.periods.x.half();
        double const length_y = r.periods.y.length(), half_y = r.periods.y.half();
        std::uint32_t count = 0;
        auto const test = [&](std::uint32_t from, std::uint32_t to) {
            for (std::uint32_t j = from; j < to; ++j) {
                Place const there = places[j];
                double x = here.x - there.x, y = here.y - there.y;
                double const z = here.z - there.z;
                if (wraps_x)
                    x = nearest_image(x, length_x, half_x);
                if (wraps_y)
                    y = nearest_image(y, length_y, half_y);
                double const near = here.radius + there.radius + r.reach;
                if (x * x + y * y + z * z < near * near && j != where.local) {
                    if (count < v.room.neighbours)
                        v.neighbour_at(now, i, count) = j;
                    ++count;
                }
            }
        };
        Cell const c = cell_at(r, here);
        Span const xs(c.x, r.nx, wraps_x), ys(c.y, r.ny, wraps_y), zs(c.z, r.nz, false);
        for (int z = zs.from; z <= zs.to; ++z)
            for (int y = ys.from; y <= ys.to; ++y) {
                int const row_y = ys.at(y);
                if (!wraps_x) { // cells of a row follow one another
                    test(start[number_of_cell(r, xs.from, row_y, z)],
                         start[number_of_cell(r, xs.to, row_y, z) + 1]);
                } else {
                    for (int x = xs.from; x <= xs.to; ++x) {
                        std::uint32_t const cell = number_of_cell(r, xs.at(x), row_y, z);
                        test(start[cell], start[cell + 1]);
                    }
                }
            }
        v.neighbours[now * v.all + i] = count;
        if (count > v.room.neighbours) {
            raise_atomically(&r.room_wanted, count);
            return;
        }
        for (std::uint32_t word = 0; word < v.words(); ++word)
            v.touching[v.at(now, v.words(), word, i)] = 0;
        carry_over(r, where, first, count);
    }

    //! Histories of the contacts that the particle had.
    DEMENS_FUNCTION void carry_over(Replica const& r, Where const& where, std::uint64_t first,
                                    std::uint32_t count) const
    {
        std::uint32_t const before = r.sorted, now = 1 - r.sorted;
        std::uint32_t const old_local = v.old_index[first + where.local];
        std::uint64_t const old = first + old_local, i = first + where.local;
        std::uint32_t const old_count = v.neighbours[before * v.all + old];
        contact::StateLayout const* const layouts = v.layouts + std::uint64_t{where.slot} * v.room.laws;
        for (std::uint32_t word = 0; word * bits_of_word < old_count; ++word)
            for (std::uint32_t left = v.touching[v.at(before, v.words(), word, old)]; left != 0;
                 left &= left - 1) {
                std::uint32_t const from = word * bits_of_word + lowest_bit(left);
                std::uint32_t const old_j = v.neighbour_at(before, old, from);
                std::uint32_t const j = v.new_index[first + old_j];
                std::uint32_t k = 0;
                while (k < count && v.neighbour_at(now, i, k) != j)
                    ++k;
                if (k == count)
                    continue; // it has gone too far within this step
                // Vectors are those of the particle that comes first: another one may do so now.
                double const sign = (old_local < old_j) == (where.local < j) ? 1.0 : -1.0;
                std::uint32_t const a = v.material[now * v.all + i], b = v.material[now * v.all + first + j];
                std::uint64_t const materials = std::uint64_t{where.slot} * v.room.materials;
                auto const scalars = static_cast<std::uint32_t>(
                    layouts[v.interaction[(materials + a) * v.room.materials + b]].scalars);
                double const* const history = v.history_of(before, old, from);
                double* const to = v.history_of(now, i, k);
                for (std::uint32_t n = 0; n < v.room.history; ++n)
                    to[n] = n < scalars ? history[n] : sign * history[n];
                v.touching[v.at(now, v.words(), k / bits_of_word, i)] |= 1u << k % bits_of_word;
            }
    }

    DEMENS_FUNCTION void find_walls(Replica& r, Where const& where, std::uint64_t first,
                                    Place const& here) const
    {
        std::uint64_t const i = first + where.local;
        std::uint32_t const before = r.sorted, now = 1 - r.sorted;
        std::uint64_t const old = first + v.old_index[i];
        FlatWall const* const walls = v.walls_of(where.slot);
        double const near = here.radius + r.reach;
        std::uint32_t count = 0, touching = 0;
        for (std::uint32_t w = 0; w < r.walls; ++w) {
            if (!walls[w].has_one_place() ||
                !(norm_squared(walls[w].offset({here.x, here.y, here.z}, here.radius)) < near * near))
                continue;
            if (count < v.room.walls) {
                v.near_wall[v.at(now, v.room.walls, count, i)] = w;
                touching |= carry_over_wall(before, now, old, i, w, count);
            }
            ++count;
        }
        v.near_walls[now * v.all + i] = count;
        v.touching_walls[now * v.all + i] = touching;
        if (count + r.mesh_slots > v.room.walls)
            raise_atomically(&r.wall_room_wanted, count);
    }

    //! The history of the contact with wall w; returns its bit, or 0 without one.
    DEMENS_FUNCTION std::uint32_t carry_over_wall(std::uint32_t before, std::uint32_t now, std::uint64_t old,
                                                  std::uint64_t i, std::uint32_t w, std::uint32_t k) const
    {
        std::uint32_t const old_count = v.near_walls[before * v.all + old];
        std::uint32_t const old_touching = v.touching_walls[before * v.all + old];
        for (std::uint32_t from = 0; from < old_count; ++from) {
            if (!(old_touching >> from & 1) || v.near_wall[v.at(before, v.room.walls, from, old)] != w)
                continue;
            double const* const history = v.wall_history_of(before, old, from);
            double* const to = v.wall_history_of(now, i, k);
            for (std::uint32_t n = 0; n < v.room.history + wall_numbers; ++n)
                to[n] = history[n];
            return 1u << k;
        }
        return 0;
    }
};

//! Which meshes are near a particle, and its contacts with them, which go on as they are: after the walls.
struct FindMeshes
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r) || r.mesh_slots == 0 || where.local >= r.particles)
            return;
        std::uint64_t const i = v.first_of(where.slot) + where.local;
        Place const here = v.place[(1 - r.current) * v.all + i];
        FlatWall const* const walls = v.walls_of(where.slot);
        std::uint32_t near = 0;
        for (std::uint32_t w = 0; w < r.walls; ++w) {
            if (walls[w].kind != FlatWall::Kind::mesh)
                continue;
            PlacedMesh const& mesh = walls[w].shape.mesh;
            if (is_near(mesh_of(v, mesh), {mesh.placement.inverse({here.x, here.y, here.z}), here.radius,
                                           here.radius + r.reach}))
                near |= 1u << w % bits_of_word;
        }
        v.near_meshes[i] = near;
        if (near != 0)
            carry_over(r, v.first_of(where.slot) + v.old_index[i], i);
    }

  private:
    DEMENS_FUNCTION void carry_over(Replica const& r, std::uint64_t old, std::uint64_t i) const
    {
        std::uint32_t const before = r.sorted, now = 1 - r.sorted;
        std::uint32_t to = v.near_walls[now * v.all + i];
        std::uint32_t const from = v.near_walls[before * v.all + old];
        std::uint32_t const bits = v.touching_walls[before * v.all + old] >> from;
        for (std::uint32_t left = bits; left != 0 && to < v.room.walls; left &= left - 1, ++to) {
            std::uint32_t const k = from + lowest_bit(left);
            v.near_wall[v.at(now, v.room.walls, to, i)] = v.near_wall[v.at(before, v.room.walls, k, old)];
            double const* const history = v.wall_history_of(before, old, k);
            for (std::uint32_t n = 0; n < v.room.history + wall_numbers; ++n)
                v.wall_history_of(now, i, to)[n] = history[n];
            v.touching_walls[now * v.all + i] |= 1u << to;
        }
    }
};

//! Whether all lists that were found have room.
DEMENS_INLINE DEMENS_FUNCTION bool lists_have_room(View const& v, Replica const& r)
{
    return r.room_wanted <= v.room.neighbours && r.wall_room_wanted + r.mesh_slots <= v.room.walls &&
           r.mesh_slots_wanted <= r.mesh_slots;
}

//! With a ledger: what contacts held that do not go on, since a wall was taken away, goes with the wall.
struct TallyDropped
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles || step_of(r) == 0 || !lists_have_room(v, r))
            return;
        std::uint64_t const first = v.first_of(where.slot), i = first + where.local;
        std::uint64_t const old = first + v.old_index[i], tables = std::uint64_t{where.slot} * v.room.laws;
        std::uint32_t const material = v.material[(1 - r.sorted) * v.all + i];
        double held = 0;
        std::uint32_t const count = v.neighbours[r.sorted * v.all + old];
        for (std::uint32_t k = 0; k < count; ++k) {
            std::uint32_t const word = v.touching[v.at(r.sorted, v.words(), k / bits_of_word, old)];
            std::uint32_t const j = v.new_index[first + v.neighbour_at(r.sorted, old, k)];
            if (!(word >> k % bits_of_word & 1) || is_neighbour(r, i, j))
                continue;
            std::uint32_t const other = v.material[(1 - r.sorted) * v.all + first + j];
            held +=
                0.5 * stored(tables + v.law_of(where.slot, material, other), v.history_of(r.sorted, old, k));
        }
        std::uint32_t const walls = v.near_walls[r.sorted * v.all + old];
        std::uint32_t const touching = v.touching_walls[r.sorted * v.all + old];
        for (std::uint32_t left = touching; left != 0; left &= left - 1) {
            std::uint32_t const k = lowest_bit(left);
            std::uint32_t const w = v.near_wall[v.at(r.sorted, v.room.walls, k, old)];
            if (k < walls ? is_touched(r, i, w) : v.near_meshes[i] != 0)
                continue;
            std::uint32_t const law = v.law_of(where.slot, material, v.walls_of(where.slot)[w].material);
            held += stored(tables + law, v.wall_history_of(r.sorted, old, k));
        }
        v.tallies[i].work_of_walls -= held;
    }

  private:
    DEMENS_FUNCTION double stored(std::uint64_t law, double const* history) const
    {
        auto const stored = contact::stored_energy_in(v.laws[law], v.layouts[law], history);
        return stored.normal + stored.tangential + stored.rolling + stored.cohesive;
    }
    DEMENS_FUNCTION bool is_neighbour(Replica const& r, std::uint64_t i, std::uint32_t j) const
    {
        std::uint32_t const now = 1 - r.sorted, count = v.neighbours[now * v.all + i];
        for (std::uint32_t k = 0; k < count; ++k)
            if (v.neighbour_at(now, i, k) == j)
                return true;
        return false;
    }
    DEMENS_FUNCTION bool is_touched(Replica const& r, std::uint64_t i, std::uint32_t wall) const
    {
        std::uint32_t const now = 1 - r.sorted, count = v.near_walls[now * v.all + i];
        for (std::uint32_t k = 0; k < count; ++k)
            if (v.near_wall[v.at(now, v.room.walls, k, i)] == wall)
                return true;
        return false;
    }
};

//! The new lists hold.
struct FinishSearch
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        if (!searches(r))
            return;
        for (int axis = 0; axis < 3; ++axis) // for the next one
            r.low[axis] = ~std::uint64_t{0}, r.high[axis] = 0;
        if (!lists_have_room(v, r)) {
            r.status = Status::full;
            r.phase = Phase::rest;
            return;
        }
        r.current = 1 - r.current;
        r.sorted = 1 - r.sorted;
        r.walls_seen = v.wall_path(where.slot);
        r.wants_lists = r.stale = 0;
        ++r.rebuilds;
    }
};

//! All of it, in order, on what launches kernels.
template <class Launcher>
void search(View const& v, Launcher&& launch)
{
    launch.over(v.room.particles, FindBounds{v});
    launch.over_replicas(LayGrid{v});
    launch.over(v.room.cells, ClearCells{v});
    launch.over(v.room.particles, CountInCells{v});
    launch.over(v.room.cells, SumCells<0>{v});
    launch.over(v.room.cells, SumCells<1>{v});
    launch.over_replicas(AddUpSums{v});
    launch.over(v.room.cells, AddUpCells<1>{v});
    launch.over(v.room.cells, AddUpCells<0>{v});
    launch.over(v.room.particles, FillCells{v});
    launch.over(v.room.particles, SortParticles{v});
    launch.over(v.room.particles, FindNeighbours{v});
    if (v.room.facets > 0)
        launch.over(v.room.particles, FindMeshes{v});
    if (v.room.has_ledger)
        launch.over(v.room.particles, TallyDropped{v});
    launch.over_replicas(FinishSearch{v});
}

} // namespace demens::dem::cuda
