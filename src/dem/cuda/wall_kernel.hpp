#pragma once

#include "src/dem/cuda/view.hpp"

namespace demens::dem::cuda {

DEMENS_INLINE DEMENS_FUNCTION contact::Sphere sphere(Place const& p, Motion const& m)
{
    return {{p.x, p.y, p.z}, p.radius, {m.vx, m.vy, m.vz}, m.mass, {m.wx, m.wy, m.wz}};
}

//! The walls near one particle in one step, as they are felt: of places that are one place only the deepest
//! counts, and others so far as they rise above the planes of the deeper ones (the rule of joined walls).
class FeltWalls
{
  public:
    struct Felt
    {
        Vector3 offset, felt; //!< of the nearest point; of what counts of it [m]
        double distance;      //!< [m]
        bool counts;
    };

    DEMENS_FUNCTION void add(std::uint32_t k, Vector3 const& offset, double reach)
    {
        double const distance = norm(offset);
        felt_[k] = {offset, offset, distance, distance < reach};
    }
    DEMENS_FUNCTION Felt const& operator[](std::uint32_t k) const { return felt_[k]; }

    //! `gap`: of the longest reach beyond the radius [m].
    DEMENS_FUNCTION void join(std::uint32_t count, double radius, double gap)
    {
        std::uint32_t order[most_near_walls];
        for (std::uint32_t k = 0; k < count; ++k) { // nearest first, of equals the first one
            std::uint32_t at = k;
            for (; at > 0 && felt_[order[at - 1]].distance > felt_[k].distance; --at)
                order[at] = order[at - 1];
            order[at] = k;
        }
        for (std::uint32_t n = 0; n < count; ++n) {
            Felt& f = felt_[order[n]];
            if (!f.counts)
                continue;
            double rise = 2 * radius + gap;
            for (std::uint32_t m = 0; m < n; ++m) {
                Felt const& deeper = felt_[order[m]];
                if (!deeper.counts)
                    continue;
                double const above = deeper.distance - dot(f.offset, deeper.offset) / deeper.distance;
                rise = above < rise ? above : rise;
            }
            if (rise <= 1e-9 * radius)
                f.counts = false;
            else if (rise < radius - f.distance)
                f.felt = ((radius - rise) / f.distance) * f.offset;
        }
    }

  private:
    Felt felt_[most_near_walls];
};

//! One place where a particle feels a wall.
struct WallContact
{
    FlatWall const& wall;
    std::uint64_t law, particle; //!< numbers among those of all slots
    Vector3 offset;              //!< from the wall to the centre [m]
    double* history;             //!< with `wall_numbers` behind
    bool is_new;
};
//! What the ledger counts of it: losses, and half of the work that the wall does in the step, beside that of
//! force and torque: the surface moves as it does where it is touched, but the torque is that of forces a
//! radius from the centre.
DEMENS_FUNCTION inline void tally_wall_contact(View const& v, Replica const& r, WallContact const& c,
                                               contact::ContactOutcome const& outcome, Vector3 const& torque)
{
    if (step_of(r) == 0)
        return;
    contact::WallSurface const& surface = c.wall.surface;
    contact::ContactGeometry const& at = outcome.geometry;
    Vector3 const force{outcome.loads.force.x, outcome.loads.force.y, outcome.loads.force.z};
    Tally& tally = v.tallies[c.particle];
    tally.lose(outcome.lost, 1);
    tally.work_of_walls += r.time_step * ((at.overlap - at.gap) * dot(surface.spin, cross(at.normal, force)) +
                                          0.5 * (dot(force, surface.velocity) - dot(torque, surface.spin)));
}

//! The other half: of the loads in the step before, kept in the places [from, to) of a particle.
DEMENS_FUNCTION inline void tally_last_loads(View const& v, Replica const& r, std::uint64_t i,
                                             FlatWall const* walls, std::uint32_t from, std::uint32_t to)
{
    if (step_of(r) == 0)
        return;
    double power = 0;
    for (std::uint32_t k = from; k < to; ++k) {
        if (!(v.touching_walls[r.sorted * v.all + i] >> k & 1))
            continue;
        FlatWall const& wall = walls[v.near_wall[v.at(r.sorted, v.room.walls, k, i)]];
        double const* const kept = v.wall_history_of(r.sorted, i, k) + v.room.history;
        Vector3 const force{kept[wall_force_at], kept[wall_force_at + 1], kept[wall_force_at + 2]},
            torque{kept[wall_torque_at], kept[wall_torque_at + 1], kept[wall_torque_at + 2]};
        if (wall.kind != FlatWall::Kind::absent)
            power += dot(force, wall.surface.velocity) + dot(torque, wall.surface.spin);
    }
    v.tallies[i].work_of_walls -= 0.5 * r.time_step * power;
}

//! A wall that is touched no more, and the law there, by its number among those of all slots.
struct PartedWall
{
    FlatWall const& wall;
    std::uint64_t law;
    Vector3 offset; //!< from it to the centre [m]
};
//! An offset along the one that is kept in place k, a little longer than the reach.
DEMENS_FUNCTION inline Vector3 parted_offset(View const& v, Replica const& r, std::uint64_t i,
                                             std::uint32_t k, double reach)
{
    double const* const was = v.wall_history_of(r.sorted, i, k) + v.room.history + wall_offset_at;
    Vector3 const old{was[0], was[1], was[2]};
    return ((1 + 1e-6) * reach / norm(old)) * old;
}
//! What a contact has lost in parting, which was kept in place k.
template <class Evaluate>
DEMENS_FUNCTION void tally_parted(View const& v, Replica const& r, std::uint64_t i, std::uint32_t k,
                                  PartedWall const& parted, Place const& here, Motion const& motion)
{
    auto const outcome = Evaluate::template evaluate<contact::Partner::wall>(
        contact::meeting(sphere(here, motion), parted.wall.surface, parted.offset), v.laws[parted.law],
        v.layouts[parted.law], r.time_step, v.wall_history_of(r.sorted, i, k), false);
    if (step_of(r) > 0)
        v.tallies[i].lose(outcome.lost, 1);
}

//! Adds its load, and notes what acts on the wall.
template <class Evaluate, bool ledger>
DEMENS_INLINE DEMENS_FUNCTION void add_wall_contact(View const& v, Replica& r, WallContact const& c,
                                                    Place const& here, Motion const& motion, Load& load)
{
    contact::WallSurface const& surface = c.wall.surface;
    contact::Meeting const meeting = contact::meeting(sphere(here, motion), surface, c.offset);
    auto const outcome = Evaluate::template evaluate<contact::Partner::wall>(
        meeting, v.laws[c.law], v.layouts[c.law], r.time_step, c.history, c.is_new);
    if (overlap_excess(meeting, outcome.geometry.overlap, r.overlap_limit) > 0)
        r.overlapping = 1;
    auto const& f = outcome.loads.force;
    auto const& t = outcome.loads.torque_i;
    load.fx += f.x, load.fy += f.y, load.fz += f.z;
    load.tx += t.x, load.ty += t.y, load.tz += t.z;
    double* const kept = c.history + v.room.history;
    kept[wall_offset_at] = c.offset.x, kept[wall_offset_at + 1] = c.offset.y;
    kept[wall_offset_at + 2] = c.offset.z;
    if (ledger || r.phase == Phase::load) {
        Vector3 const force{f.x, f.y, f.z}, torque_i{t.x, t.y, t.z};
        Vector3 const arm = Vector3{here.x, here.y, here.z} - surface.pivot;
        Vector3 const torque = contact::torque_on_wall(arm, force, torque_i);
        if constexpr (ledger)
            tally_wall_contact(v, r, c, outcome, torque);
        kept[wall_force_at] = -f.x, kept[wall_force_at + 1] = -f.y, kept[wall_force_at + 2] = -f.z;
        kept[wall_torque_at] = torque.x, kept[wall_torque_at + 1] = torque.y;
        kept[wall_torque_at + 2] = torque.z;
    }
}

//! Adds the loads of a particle's contacts with walls that are no meshes.
template <class Evaluate, bool ledger = false>
DEMENS_FUNCTION void add_walls(View const& v, Replica& r, std::uint32_t slot, std::uint64_t i,
                               Place const& here, Motion const& motion, Load& load)
{
    std::uint32_t const sorted = r.sorted, count = v.near_walls[sorted * v.all + i];
    std::uint32_t& bits = v.touching_walls[sorted * v.all + i];
    std::uint32_t old = bits, now = 0;
    FlatWall const* const walls = v.walls_of(slot);
    std::uint32_t const material = v.material[sorted * v.all + i];
    std::uint64_t const tables = std::uint64_t{slot} * v.room.laws;
    auto const wall_at = [&](std::uint32_t k) -> FlatWall const& {
        return walls[v.near_wall[v.at(sorted, v.room.walls, k, i)]];
    };
    auto const law_at = [&](std::uint32_t k) { return v.law_of(slot, material, wall_at(k).material); };
    if constexpr (ledger)
        tally_last_loads(v, r, i, walls, 0, count);
    Vector3 const centre{here.x, here.y, here.z};
    FeltWalls felt;
    double gap = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        contact::Range const& range = v.ranges[tables + law_at(k)];
        double const furthest = range.gap > gap ? range.gap : gap;
        gap = furthest;
        felt.add(k, wall_at(k).offset(centre, here.radius), here.radius + range.gap);
    }
    if (count > 1) {
        felt.join(count, here.radius, gap);
        // A contact that goes on from one wall to the next takes its history along.
        for (std::uint32_t k = 0; k < count; ++k)
            for (std::uint32_t from = 0; from < count && felt[k].counts && !(old >> k & 1); ++from) {
                double* const left = v.wall_history_of(sorted, i, from);
                double const* const was = left + v.room.history + wall_offset_at;
                if (felt[from].counts || !(old >> from & 1) || law_at(from) != law_at(k) ||
                    !is_like({was[0], was[1], was[2]}, felt[k].offset))
                    continue;
                double* const to = v.wall_history_of(sorted, i, k);
                for (std::uint32_t n = 0; n < v.room.history; ++n)
                    to[n] = left[n];
                old = (old & ~(1u << from)) | 1u << k;
            }
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        std::uint32_t const law = law_at(k);
        double const reach = here.radius + v.ranges[tables + law].reach(old >> k & 1);
        Vector3 const offset = felt[k].felt;
        if (!felt[k].counts || !(norm_squared(offset) < reach * reach)) {
            if constexpr (ledger)
                if (old >> k & 1) {
                    bool const is_away = felt[k].counts || felt[k].distance >= here.radius + gap;
                    tally_parted<Evaluate>(v, r, i, k,
                                           {wall_at(k), tables + law,
                                            is_away ? offset : parted_offset(v, r, i, k, here.radius + gap)},
                                           here, motion);
                }
            continue;
        }
        now |= 1u << k;
        add_wall_contact<Evaluate, ledger>(
            v, r, {wall_at(k), tables + law, i, offset, v.wall_history_of(sorted, i, k), !(old >> k & 1)},
            here, motion, load);
    }
    bits = now | old >> count << count; // contacts with meshes are kept behind
}

} // namespace demens::dem::cuda
