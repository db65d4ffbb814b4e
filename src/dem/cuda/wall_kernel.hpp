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
    std::uint64_t law; //!< number among those of all slots
    Vector3 offset;    //!< from the wall to the centre [m]
    double* history;   //!< with `wall_numbers` behind
    bool is_new;
};
//! Adds its load, and notes what acts on the wall.
template <class Evaluate>
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
    if (r.phase == Phase::load) {
        Vector3 const force{f.x, f.y, f.z}, torque_i{t.x, t.y, t.z};
        Vector3 const arm = Vector3{here.x, here.y, here.z} - surface.pivot;
        Vector3 const torque = contact::torque_on_wall(arm, force, torque_i);
        kept[wall_force_at] = -f.x, kept[wall_force_at + 1] = -f.y, kept[wall_force_at + 2] = -f.z;
        kept[wall_torque_at] = torque.x, kept[wall_torque_at + 1] = torque.y;
        kept[wall_torque_at + 2] = torque.z;
    }
}

//! Adds the loads of a particle's contacts with walls that are no meshes.
template <class Evaluate>
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
        if (!felt[k].counts || !(norm_squared(offset) < reach * reach))
            continue;
        now |= 1u << k;
        add_wall_contact<Evaluate>(
            v, r, {wall_at(k), tables + law, offset, v.wall_history_of(sorted, i, k), !(old >> k & 1)}, here,
            motion, load);
    }
    bits = now | old >> count << count; // contacts with meshes are kept behind
}

} // namespace demens::dem::cuda
