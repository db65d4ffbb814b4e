#pragma once

#include "src/dem/cuda/bits.hpp"
#include "src/dem/cuda/view.hpp"

namespace demens::dem::cuda {

// Lists made anew, in all replicas that want it and in no other. Nothing that holds is changed before the
// last kernel: a replica whose lists find no room is as it was, and tries again when there is more.

//! Whether this replica's lists are being made anew.
DEMENS_INLINE DEMENS_FUNCTION bool searches(Replica const& r)
{
    return r.wants_lists != 0 && r.status == Status::running;
}

//! Puts particles back into the periods, and finds out where they are.
struct FindBounds
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles)
            return;
        Place& p = v.place[r.current * v.all + v.first_of(where.slot) + where.local];
        if (r.periods.any()) {
            Place const before = p;
            p.x = r.periods.x.wrapped(p.x);
            p.y = r.periods.y.wrapped(p.y);
            if (v.room.has_ledger && step_of(r) > 0) { // a jump in gravity brings energy in
                std::uint64_t const i = v.first_of(where.slot) + where.local;
                v.tallies[i].brought_in -= v.motion[r.current * v.all + i].mass *
                                           (r.gravity.x * (p.x - before.x) + r.gravity.y * (p.y - before.y));
            }
        }
        if (!(p.x >= r.lower.x && p.y >= r.lower.y && p.z >= r.lower.z && p.x <= r.upper.x &&
              p.y <= r.upper.y && p.z <= r.upper.z)) {
            r.outside = 1; // or is not a number
            return;
        }
        double const at[3] = {p.x, p.y, p.z};
        for (int axis = 0; axis < 3; ++axis) {
            lower_atomically(&r.low[axis], ordered(at[axis]));
            raise_atomically(&r.high[axis], ordered(at[axis]));
        }
    }
};

//! The grid: cells that a particle and its reach fit into, but no more of them than there is room for.
struct LayGrid
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        if (!searches(r))
            return;
        if (r.outside) {
            r.status = Status::escaped;
            r.phase = Phase::rest;
            return;
        }
        double low[3], length[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = r.particles > 0 ? number_of(r.low[axis]) : 0;
            length[axis] = r.particles > 0 ? number_of(r.high[axis]) - low[axis] : 0;
        }
        Period const periods[3] = {r.periods.x, r.periods.y, {}};
        for (int axis = 0; axis < 2; ++axis)
            if (periods[axis].on())
                low[axis] = periods[axis].lower, length[axis] = periods[axis].length();
        double cell = r.cell;
        double n[3];
        for (;; cell *= 1.25) {
            for (int axis = 0; axis < 3; ++axis) {
                // A period holds whole cells.
                n[axis] = std::floor(length[axis] / cell) + (periods[axis].on() ? 0 : 1);
                n[axis] = n[axis] > 1 ? n[axis] : 1;
            }
            if (n[0] * n[1] * n[2] <= v.room.cells)
                break;
        }
        r.origin = {low[0], low[1], low[2]};
        r.nx = static_cast<int>(n[0]), r.ny = static_cast<int>(n[1]), r.nz = static_cast<int>(n[2]);
        r.per_length = {periods[0].on() ? n[0] / length[0] : 1 / cell,
                        periods[1].on() ? n[1] / length[1] : 1 / cell, 1 / cell};
        r.room_wanted = r.wall_room_wanted = 0;
    }
};

DEMENS_INLINE DEMENS_FUNCTION std::uint32_t cells_of(Replica const& r)
{
    return static_cast<std::uint32_t>(r.nx * r.ny * r.nz);
}

DEMENS_INLINE DEMENS_FUNCTION int cell_along(double at, double origin, double per_length, int n)
{
    int const cell = static_cast<int>((at - origin) * per_length);
    return cell < 0 ? 0 : cell < n ? cell : n - 1;
}

struct Cell
{
    int x, y, z;
};
DEMENS_INLINE DEMENS_FUNCTION Cell cell_at(Replica const& r, Place const& p)
{
    return {cell_along(p.x, r.origin.x, r.per_length.x, r.nx),
            cell_along(p.y, r.origin.y, r.per_length.y, r.ny),
            cell_along(p.z, r.origin.z, r.per_length.z, r.nz)};
}
DEMENS_INLINE DEMENS_FUNCTION std::uint32_t number_of_cell(Replica const& r, int x, int y, int z)
{
    return static_cast<std::uint32_t>((z * r.ny + y) * r.nx + x);
}

//! Over cells.
struct ClearCells
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (searches(r) && where.local <= cells_of(r) && where.local < v.room.cells)
            v.cell_starts_of(where.slot)[where.local] = 0;
    }
};

struct CountInCells
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles)
            return;
        std::uint64_t const i = v.first_of(where.slot) + where.local;
        Cell const c = cell_at(r, v.place[r.current * v.all + i]);
        std::uint32_t const cell = number_of_cell(r, c.x, c.y, c.z);
        v.cell_of[i] = cell;
        v.place_in_cell[i] = add_atomically(&v.cell_starts_of(where.slot)[cell], 1);
    }
};

// Where cells begin: sums of 32, of 32 of these, all of those in turn, and back.
constexpr std::uint32_t summed = 32;

DEMENS_INLINE DEMENS_FUNCTION std::uint32_t parts(std::uint32_t count)
{
    return (count + summed - 1) / summed;
}

//! Sums over `summed` numbers each.
DEMENS_INLINE DEMENS_FUNCTION void sum_parts(std::uint32_t const* numbers, std::uint32_t count,
                                             std::uint32_t part, std::uint32_t* sums)
{
    std::uint32_t sum = 0;
    for (std::uint32_t k = part * summed; k < (part + 1) * summed && k < count; ++k)
        sum += numbers[k];
    sums[part] = sum;
}
//! Numbers become what is before them, from `before` on.
DEMENS_INLINE DEMENS_FUNCTION void add_up(std::uint32_t* numbers, std::uint32_t from, std::uint32_t to,
                                          std::uint32_t before)
{
    for (std::uint32_t k = from; k < to; ++k) {
        std::uint32_t const own = numbers[k];
        numbers[k] = before;
        before += own;
    }
}

//! Over cells. `level` 0: sums of cells, 1: sums of these.
template <int level>
struct SumCells
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        std::uint32_t const cells = cells_of(r), count = level == 0 ? cells : parts(cells);
        if (!searches(r) || where.local >= parts(count))
            return;
        auto* const sums = v.sums + std::uint64_t{where.slot} * parts(v.room.cells);
        if (level == 0)
            sum_parts(v.cell_starts_of(where.slot), count, where.local, sums);
        else
            sum_parts(sums, count, where.local,
                      v.sums_of_sums + std::uint64_t{where.slot} * parts(parts(v.room.cells)));
    }
};

//! Over replicas.
struct AddUpSums
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r))
            return;
        std::uint32_t const cells = cells_of(r);
        add_up(v.sums_of_sums + std::uint64_t{where.slot} * parts(parts(v.room.cells)), 0,
               parts(parts(cells)), 0);
        v.cell_starts_of(where.slot)[cells] = r.particles;
    }
};

//! Over cells. `level` 1: sums, 0: cells.
template <int level>
struct AddUpCells
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        std::uint32_t const cells = cells_of(r), count = level == 0 ? cells : parts(cells);
        if (!searches(r) || where.local >= parts(count))
            return;
        auto* const sums = v.sums + std::uint64_t{where.slot} * parts(v.room.cells);
        auto* const numbers = level == 0 ? v.cell_starts_of(where.slot) : sums;
        std::uint32_t const before =
            level == 0 ? sums[where.local]
                       : v.sums_of_sums[std::uint64_t{where.slot} * parts(parts(v.room.cells)) + where.local];
        std::uint32_t const end = (where.local + 1) * summed;
        add_up(numbers, where.local * summed, end < count ? end : count, before);
    }
};

//! Puts particles into their cells, as they come.
struct FillCells
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles)
            return;
        std::uint64_t const first = v.first_of(where.slot), i = first + where.local;
        std::uint32_t const start = v.cell_starts_of(where.slot)[v.cell_of[i]];
        v.bucket[first + start + v.place_in_cell[i]] = where.local;
    }
};

//! Sorts particles along the cells, and in a cell by their ids: an order that does not depend on who came
//! first.
struct SortParticles
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica const& r = v.replica[where.slot];
        if (!searches(r) || where.local >= r.particles)
            return;
        std::uint64_t const first = v.first_of(where.slot), i = first + where.local;
        std::uint64_t const old = r.sorted * v.all, now = (1 - r.sorted) * v.all;
        std::uint32_t const* const start = v.cell_starts_of(where.slot) + v.cell_of[i];
        std::uint32_t const id = v.id[old + i];
        std::uint32_t to = start[0];
        for (std::uint32_t k = start[0]; k < start[1]; ++k)
            to += v.id[old + first + v.bucket[first + k]] < id;
        v.new_index[i] = to;
        v.old_index[first + to] = where.local;
        Place const place = v.place[r.current * v.all + i];
        v.place[(1 - r.current) * v.all + first + to] = place;
        v.motion[(1 - r.current) * v.all + first + to] = v.motion[r.current * v.all + i];
        v.seen[now + first + to] = place;
        v.id[now + first + to] = id;
        v.material[now + first + to] = v.material[old + i];
    }
};

} // namespace demens::dem::cuda
