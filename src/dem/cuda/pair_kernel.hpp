#pragma once

#include "src/dem/cuda/bits.hpp"
#include "src/dem/cuda/known_laws.hpp"
#include "src/dem/cuda/view.hpp"

namespace demens::dem::cuda {

DEMENS_INLINE DEMENS_FUNCTION Vector3 nearest_difference(Replica const& r, bool periodic, Place const& a,
                                                         Place const& b)
{
    Vector3 apart{a.x - b.x, a.y - b.y, a.z - b.z};
    if (periodic) {
        apart.x = nearest_image(apart.x, r.periods.x.length(), r.periods.x.half());
        apart.y = nearest_image(apart.y, r.periods.y.length(), r.periods.y.half());
    }
    return apart;
}

//! The law set of a particle and particle j of its replica.
DEMENS_INLINE DEMENS_FUNCTION std::uint32_t law_of_pair(View const& v, Replica const& r, Where const& where,
                                                        std::uint32_t j)
{
    std::uint32_t const* const material = v.material + r.sorted * v.all + v.first_of(where.slot);
    std::uint32_t const own = material[where.local], other = material[j];
    return where.local < j ? v.law_of(where.slot, own, other) : v.law_of(where.slot, other, own);
}

//! What a word of a particle's list says of contacts: a bit each of those that are there, and that are new.
struct WordOfContacts
{
    std::uint32_t touching, made;
};
//! Looks which neighbours of a word of a particle's list are in reach, and notes it.
DEMENS_FUNCTION inline WordOfContacts find_contacts(View const& v, Replica const& r, Where const& where,
                                                    std::uint32_t word)
{
    std::uint64_t const first = v.first_of(where.slot), i = first + where.local;
    std::uint32_t const sorted = r.sorted, from = word * bits_of_word;
    std::uint32_t const count = where.local < r.particles ? v.neighbours[sorted * v.all + i] : 0;
    if (count <= from)
        return {0, 0};
    std::uint32_t const end = count - from < bits_of_word ? count - from : bits_of_word;
    contact::Range const* const ranges = v.ranges + std::uint64_t{where.slot} * v.room.laws;
    bool const periodic = r.periods.any();
    bool const one_material = r.materials == 1;
    double const made_gap = ranges->reach(false), old_gap = ranges->reach(true);
    std::uint32_t& bits = v.touching[v.at(sorted, v.words(), word, i)];
    std::uint32_t const old = bits;
    Place const* const places = v.place + r.current * v.all + first;
    Place const here = places[where.local];
    std::uint32_t now = 0;
    for (std::uint32_t k = 0; k < end; k += 4) {
        FourNeighbours const four = v.four_neighbours_at(sorted, i, from + k);
        Place there[4]; // beyond the end the particle itself
        for (std::uint32_t n = 0; n < 4; ++n)
            there[n] = places[k + n < end ? four.number[n] : where.local];
        for (std::uint32_t n = 0; n < 4; ++n) {
            bool const touched = old >> (k + n) & 1;
            double gap = touched ? old_gap : made_gap;
            if (!one_material && k + n < end)
                gap = ranges[law_of_pair(v, r, where, four.number[n])].reach(touched);
            double const reach = here.radius + there[n].radius + gap;
            bool const touches =
                norm_squared(nearest_difference(r, periodic, here, there[n])) < reach * reach;
            now |= static_cast<std::uint32_t>(touches && k + n < end) << (k + n);
        }
    }
    if (now != old)
        bits = now;
    return {now, now & ~old};
}

//! A contact of a particle with particle j; its history may be a copy.
template <class Evaluate>
DEMENS_INLINE DEMENS_FUNCTION contact::ContactOutcome
outcome_of_pair(View const& v, Replica& r, Where const& where, std::uint32_t j, double* history, bool is_new)
{
    std::uint32_t const law = r.materials == 1 ? 0 : law_of_pair(v, r, where, j);
    std::uint64_t const table = std::uint64_t{where.slot} * v.room.laws + law;
    // The particle with the lower number comes first, whoever of the two computes.
    bool const is_first = where.local < j;
    std::uint64_t const set = r.current * v.all + v.first_of(where.slot);
    std::uint64_t const a = set + (is_first ? where.local : j), b = set + (is_first ? j : where.local);
    Place const place_a = v.place[a], place_b = v.place[b];
    contact::Meeting const meeting =
        contact::meeting(sphere(place_a, v.motion[a]), sphere(place_b, v.motion[b]),
                         nearest_difference(r, r.periods.any(), place_a, place_b));
    auto const outcome = Evaluate::template evaluate<contact::Partner::sphere>(
        meeting, v.laws[table], v.layouts[table], r.time_step, history, is_new);
    if (overlap_excess(meeting, outcome.geometry.overlap, r.overlap_limit) > 0)
        r.overlapping = 1;
    return outcome;
}

//! Entry k of a particle's list: what it does to the particle.
template <class Evaluate>
DEMENS_INLINE DEMENS_FUNCTION Load evaluate_pair(View const& v, Replica& r, Where const& where,
                                                 std::uint32_t k, bool is_new)
{
    std::uint64_t const i = v.first_of(where.slot) + where.local;
    std::uint32_t const sorted = r.sorted, j = v.neighbour_at(sorted, i, k);
    auto const outcome = outcome_of_pair<Evaluate>(v, r, where, j, v.history_of(sorted, i, k), is_new);
    bool const is_first = where.local < j;
    double const sign = is_first ? 1.0 : -1.0;
    auto const& f = outcome.loads.force;
    auto const& torque = is_first ? outcome.loads.torque_i : outcome.loads.torque_j;
    return {sign * f.x, sign * f.y, sign * f.z, 0, torque.x, torque.y, torque.z, 0};
}

} // namespace demens::dem::cuda
