#pragma once

#include "src/dem/cuda/pair_kernel.hpp"
#include "src/dem/cuda/team_queue.hpp"
#include "src/dem/cuda/wall_kernel.hpp"
#include "src/dem/surrounding_forces.hpp"

namespace demens::dem::cuda {

//! Particles of a team, one step: the loads of all their contacts, each in the order of its list, and their
//! motion.
//!
//! Each contact is evaluated by both of its particles, from the same numbers in the same order of the two, so
//! that they agree bit for bit on force and history, and no team waits for another. What others read (places,
//! motions) is written to the other set. Particles have unlike numbers of contacts: a team deals all that it
//! has to its lanes, and each particle then adds up its own, in order.
template <class Evaluate, bool ledger = false>
struct StepKernel
{
    View v;
    LawKernel kernel; //!< replicas of others are left alone

    template <class Team>
    DEMENS_FUNCTION void operator()(Team const& team, TeamQueue& queue) const
    {
        Replica& r = v.replica[team.slot];
        Phase const phase = r.phase;
        if (phase == Phase::rest || r.kernel != kernel)
            return;
        std::uint64_t const first = v.first_of(team.slot) + team.first;
        typename Team::template Own<Load> load;
        if (phase == Phase::move) {
            team.each([&](std::uint32_t lane) { load[lane] = v.load[first + lane]; });
        } else {
            team.each(
                [&](std::uint32_t lane) { load[lane] = r.has_outer_loads ? v.load[first + lane] : Load{}; });
            add_pairs(team, queue, r, load);
            deal_walls(team, queue, r, load);
        }
        std::uint64_t const set = r.current * v.all;
        team.each([&](std::uint32_t lane) {
            if (team.first + lane >= r.particles)
                return;
            std::uint64_t const i = first + lane;
            if constexpr (ledger)
                if (phase != Phase::move && r.has_surroundings)
                    tally_surroundings(r, i, v.place[set + i], v.motion[set + i], load[lane]);
            if (phase == Phase::load)
                keep(r, i, v.motion[set + i], load[lane]);
            else
                move(r, i, v.place[set + i], v.motion[set + i], load[lane]);
        });
    }

  private:
    //! Of all pairs, in rounds of as many as the queue has room for.
    template <class Team, class Loads>
    DEMENS_INLINE DEMENS_FUNCTION void add_pairs(Team const& team, TeamQueue& queue, Replica& r,
                                                 Loads& load) const
    {
        typename Team::template Own<WordOfContacts> found;
        typename Team::template Own<std::uint32_t> place; // in the queue, of the first
        for (std::uint32_t word = 0; word < v.words(); ++word) {
            team.each([&](std::uint32_t lane) {
                found[lane] = find_contacts(v, r, {team.slot, team.first + lane}, word);
                place[lane] = number_of_bits(found[lane].touching);
            });
            std::uint32_t const count = team.add_up(place);
            for (std::uint32_t from = 0; from < count; from += queue.room) {
                std::uint32_t const end = count - from < queue.room ? count - from : queue.room;
                team.each([&](std::uint32_t lane) {
                    std::uint32_t at = place[lane] - from; // in earlier rounds: beyond the end
                    for (std::uint32_t left = found[lane].touching; left != 0; left &= left - 1, ++at)
                        if (at < end) {
                            std::uint32_t const k = lowest_bit(left);
                            queue.contact[at] = QueuedContact::of(lane, k, found[lane].made >> k & 1);
                        }
                });
                team.deal(end, [&](std::uint32_t at) {
                    QueuedContact const c = queue.contact[at];
                    queue.keep(at, evaluate_pair<Evaluate>(v, r, {team.slot, team.first + c.lane()},
                                                           word * bits_of_word + c.entry(), c.is_new()));
                });
                team.each([&](std::uint32_t lane) {
                    std::uint32_t at = place[lane] - from;
                    for (std::uint32_t left = number_of_bits(found[lane].touching); left != 0; --left, ++at)
                        if (at < end)
                            add(load[lane], queue.load_of(at));
                });
            }
        }
    }

    //! Of walls: few particles are near any, so that those are gathered and dealt to as few warps as can be.
    template <class Team, class Loads>
    DEMENS_INLINE DEMENS_FUNCTION void deal_walls(Team const& team, TeamQueue& queue, Replica& r,
                                                  Loads& load) const
    {
        std::uint64_t const first = v.first_of(team.slot) + team.first, set = r.current * v.all;
        typename Team::template Own<std::uint32_t> near, place;
        team.each([&](std::uint32_t lane) {
            near[lane] = team.first + lane < r.particles && v.near_walls[r.sorted * v.all + first + lane] > 0;
            place[lane] = near[lane];
        });
        std::uint32_t const count = team.add_up(place);
        if (count == 0)
            return;
        team.each([&](std::uint32_t lane) {
            if (near[lane]) {
                queue.contact[place[lane]] = QueuedContact::of(lane, 0, false);
                queue.keep(place[lane], load[lane]);
            }
        });
        team.deal(count, [&](std::uint32_t k) {
            std::uint64_t const i = first + queue.contact[k].lane();
            Load sum = queue.load_of(k);
            add_walls<Evaluate, ledger>(v, r, team.slot, i, v.place[set + i], v.motion[set + i], sum);
            queue.keep(k, sum);
        });
        team.each([&](std::uint32_t lane) {
            if (near[lane])
                load[lane] = queue.load_of(place[lane]);
        });
    }

    //! Work of drag and vibration: half of that on the path that led here, and half on the next.
    DEMENS_FUNCTION void tally_surroundings(Replica const& r, std::uint64_t i, Place const& here,
                                            Motion const& m, Load const& l) const
    {
        double const dt = r.time_step, kick = step_of(r) == 0 ? 0.5 * dt : dt;
        Vector3 const acceleration =
            acceleration_in(r.surroundings, static_cast<double>(step_of(r)) * r.time_step);
        auto const [drag, shaking] = forces_on(r.surroundings, here, m, acceleration);
        Vector3 const before{m.vx, m.vy, m.vz};
        Vector3 const after = before + kick * (Vector3{l.fx, l.fy, l.fz} / m.mass + r.gravity);
        Tally& tally = v.tallies[i];
        if (step_of(r) > 0) {
            tally.damping -= tally.drag_to_come + 0.5 * dt * dot(drag, before);
            tally.work_of_walls += tally.vibration_to_come + 0.5 * dt * dot(shaking, before);
        }
        tally.drag_to_come = 0.5 * dt * dot(drag, after);
        tally.vibration_to_come = 0.5 * dt * dot(shaking, after);
    }

    DEMENS_INLINE DEMENS_FUNCTION static void add(Load& sum, Load const& l)
    {
        sum.fx += l.fx, sum.fy += l.fy, sum.fz += l.fz;
        sum.tx += l.tx, sum.ty += l.ty, sum.tz += l.tz;
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
