#pragma once

#include "src/dem/cuda/bits.hpp"
#include "src/dem/cuda/known_laws.hpp"
#include "src/dem/cuda/wall_kernel.hpp"

namespace demens::dem::cuda {

//! One particle, one step: the loads of all its contacts, in the order of its list, and its motion.
//!
//! Each contact is evaluated by both of its particles, from the same numbers in the same order of the two, so
//! that they agree bit for bit on force and history, and nobody waits for anybody. What others read (places,
//! motions) is written to the other set.
template <class Evaluate>
struct StepKernel
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        Phase const phase = r.phase;
        if (phase == Phase::rest || where.local >= r.particles)
            return;
        std::uint64_t const first = v.first_of(where.slot), i = first + where.local;
        std::uint64_t const set = r.current * v.all;
        Place const here = v.place[set + i];
        Motion const motion = v.motion[set + i];
        Load load;
        if (phase == Phase::move) {
            load = v.load[i];
        } else {
            load = r.has_outer_loads ? v.load[i] : Load{};
            add_pairs(r, where, first, here, motion, load);
            if (v.near_walls[r.sorted * v.all + i] > 0)
                add_walls<Evaluate>(v, r, where.slot, i, here, motion, load);
        }
        if (phase == Phase::load)
            keep(r, i, motion, load);
        else
            move(r, i, here, motion, load);
    }

  private:
    DEMENS_FUNCTION void add_pairs(Replica& r, Where const& where, std::uint64_t first, Place const& here,
                                   Motion const& motion, Load& load) const
    {
        std::uint64_t const i = first + where.local, set = r.current * v.all;
        std::uint32_t const sorted = r.sorted;
        std::uint32_t const count = v.neighbours[sorted * v.all + i];
        contact::LawSet const* const laws = v.laws + std::uint64_t{where.slot} * v.room.laws;
        contact::Range const* const ranges = v.ranges + std::uint64_t{where.slot} * v.room.laws;
        bool const periodic = r.periods.any();
        bool const one_material = r.materials == 1;
        std::uint32_t const material = one_material ? 0 : v.material[sorted * v.all + i];
        for (std::uint32_t from = 0; from < count; from += bits_of_word) {
            std::uint32_t const word = from / bits_of_word;
            std::uint32_t& bits = v.touching[v.at(sorted, v.words(), word, i)];
            std::uint32_t const old = bits;
            std::uint32_t const end = count - from < bits_of_word ? count - from : bits_of_word;
            std::uint32_t now = 0;
            for (std::uint32_t k = 0; k < end; ++k) {
                std::uint32_t const j = v.neighbour[v.at(sorted, v.room.neighbours, from + k, i)];
                Place const there = v.place[set + first + j];
                Vector3 const apart = difference(r, periodic, here, there);
                std::uint32_t const law = one_material ? 0 : law_of(where, sorted, first, material, j);
                double const reach = here.radius + there.radius + ranges[law].reach(old >> k & 1);
                now |= static_cast<std::uint32_t>(norm_squared(apart) < reach * reach) << k;
            }
            for (std::uint32_t left = now; left != 0; left &= left - 1) {
                std::uint32_t const k = lowest_bit(left);
                std::uint32_t const j = v.neighbour[v.at(sorted, v.room.neighbours, from + k, i)];
                std::uint32_t const law = one_material ? 0 : law_of(where, sorted, first, material, j);
                add_pair(r, laws[law], v.layouts[std::uint64_t{where.slot} * v.room.laws + law],
                         {where.local < j, periodic, !(old >> k & 1)}, here, motion, v.place[set + first + j],
                         v.motion[set + first + j], v.history_of(sorted, i, from + k), load);
            }
            if (now != old)
                bits = now;
        }
    }

    struct How
    {
        bool is_first, periodic, is_new;
    };
    DEMENS_INLINE DEMENS_FUNCTION void add_pair(Replica& r, contact::LawSet const& laws,
                                                contact::StateLayout const& layout, How const& how,
                                                Place const& here, Motion const& motion, Place const& there,
                                                Motion const& other, double* history, Load& load) const
    {
        // The particle with the lower number comes first, whoever of the two computes.
        contact::Sphere const me = sphere(here, motion), it = sphere(there, other);
        Vector3 const apart = difference(r, how.periodic, here, there);
        contact::Meeting const meeting =
            how.is_first ? contact::meeting(me, it, apart) : contact::meeting(it, me, -apart);
        auto const outcome = Evaluate::template evaluate<contact::Partner::sphere>(
            meeting, laws, layout, r.time_step, history, how.is_new);
        if (overlap_excess(meeting, outcome.geometry.overlap, r.overlap_limit) > 0)
            r.overlapping = 1;
        auto const& f = outcome.loads.force;
        auto const& torque = how.is_first ? outcome.loads.torque_i : outcome.loads.torque_j;
        double const sign = how.is_first ? 1.0 : -1.0;
        load.fx += sign * f.x, load.fy += sign * f.y, load.fz += sign * f.z;
        load.tx += torque.x, load.ty += torque.y, load.tz += torque.z;
    }

    DEMENS_INLINE DEMENS_FUNCTION static Vector3 difference(Replica const& r, bool periodic, Place const& a,
                                                            Place const& b)
    {
        Vector3 apart{a.x - b.x, a.y - b.y, a.z - b.z};
        if (periodic) {
            apart.x = nearest_image(apart.x, r.periods.x.length(), r.periods.x.half());
            apart.y = nearest_image(apart.y, r.periods.y.length(), r.periods.y.half());
        }
        return apart;
    }

    //! The law set of this particle and particle j of the replica.
    DEMENS_INLINE DEMENS_FUNCTION std::uint32_t law_of(Where const& where, std::uint32_t sorted,
                                                       std::uint64_t first, std::uint32_t material,
                                                       std::uint32_t j) const
    {
        std::uint32_t const other = v.material[sorted * v.all + first + j];
        std::uint32_t const a = where.local < j ? material : other, b = where.local < j ? other : material;
        return v.interaction[(std::uint64_t{where.slot} * v.room.materials + a) * v.room.materials + b];
    }

    DEMENS_INLINE DEMENS_FUNCTION void keep(Replica& r, std::uint64_t i, Motion const& m,
                                            Load const& load) const
    {
        v.load[i] = load;
        check(r, m, load);
    }

    DEMENS_INLINE DEMENS_FUNCTION void move(Replica& r, std::uint64_t i, Place place, Motion m,
                                            Load const& load) const
    {
        double const dt = r.time_step;
        double const kick = r.first_kick_is_half && r.step == 0 ? 0.5 * dt : dt;
        double const per_mass = kick / m.mass, per_inertia = kick / m.inertia;
        m.vx += load.fx * per_mass + kick * r.gravity.x;
        m.vy += load.fy * per_mass + kick * r.gravity.y;
        m.vz += load.fz * per_mass + kick * r.gravity.z;
        m.wx += load.tx * per_inertia;
        m.wy += load.ty * per_inertia;
        m.wz += load.tz * per_inertia;
        place.x += dt * m.vx;
        place.y += dt * m.vy;
        place.z += dt * m.vz;
        std::uint64_t const other = (1 - r.current) * v.all;
        v.motion[other + i] = m;
        v.place[other + i] = place;
        check(r, m, load);
        double const speed = m.vx * m.vx + m.vy * m.vy + m.vz * m.vz;
        if (dt * dt * speed > place.radius * place.radius)
            r.leaping = 1;
        Place const seen = v.seen[r.sorted * v.all + i];
        double const x = place.x - seen.x, y = place.y - seen.y, z = place.z - seen.z;
        if (!(x * x + y * y + z * z <= r.trigger))
            r.wants_lists = 1;
    }

    DEMENS_INLINE DEMENS_FUNCTION static void check(Replica& r, Motion const& m, Load const& l)
    {
        double const sum = m.vx + m.vy + m.vz + m.wx + m.wy + m.wz + l.fx + l.fy + l.fz + l.tx + l.ty + l.tz;
        if (sum * 0 != 0)
            r.broken = 1;
    }
};

//! Over replicas, after each step: whose places hold, and what comes next. Returns whether lists are wanted.
struct Tick
{
    View v;

    DEMENS_FUNCTION bool operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        if (r.phase == Phase::rest)
            return false;
        if (r.broken) {
            r.status = Status::not_a_number;
            r.phase = Phase::rest;
            return false;
        }
        if (r.phase == Phase::load) {
            r.phase = Phase::rest;
            return false;
        }
        r.current = 1 - r.current;
        ++r.step;
        r.phase = r.step < r.steps ? Phase::load_and_move : Phase::load;
        if (r.stale || v.wall_path(where.slot) - r.walls_seen > r.wall_trigger ||
            r.mesh_slots_wanted > r.mesh_slots)
            r.wants_lists = 1;
        return r.wants_lists != 0;
    }
};

} // namespace demens::dem::cuda
