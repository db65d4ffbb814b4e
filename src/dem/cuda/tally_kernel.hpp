#pragma once

#include "src/dem/cuda/pair_kernel.hpp"

namespace demens::dem::cuda {

//! With a ledger, before the step kernel: what the contacts of one particle with others lose in a step, those
//! that part, too. They are evaluated on copies of their histories; the other particle has the other half.
struct TallyPairs
{
    View v;

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        bool const finds_loads = r.phase == Phase::load_and_move || r.phase == Phase::load;
        if (r.kernel != LawKernel::any_with_ledger || !finds_loads || where.local >= r.particles ||
            step_of(r) == 0)
            return;
        std::uint64_t const i = v.first_of(where.slot) + where.local;
        std::uint32_t const count = v.neighbours[r.sorted * v.all + i];
        Tally tally = v.tallies[i];
        for (std::uint32_t k = 0; k < count; ++k) {
            std::uint32_t const j = v.neighbour_at(r.sorted, i, k);
            std::uint32_t const word = v.touching[v.at(r.sorted, v.words(), k / bits_of_word, i)];
            bool const touched = word >> k % bits_of_word & 1;
            if (touched || is_in_reach(r, where, j))
                lose(r, where, i, k, touched, tally);
        }
        v.tallies[i] = tally;
    }

  private:
    //! Whether they touch, that did not.
    DEMENS_FUNCTION bool is_in_reach(Replica const& r, Where const& where, std::uint32_t j) const
    {
        Place const* const places = v.place + r.current * v.all + v.first_of(where.slot);
        Place const here = places[where.local], there = places[j];
        contact::Range const& range =
            v.ranges[std::uint64_t{where.slot} * v.room.laws + law_of_pair(v, r, where, j)];
        double const reach = here.radius + there.radius + range.reach(false);
        return norm_squared(nearest_difference(r, r.periods.any(), here, there)) < reach * reach;
    }

    DEMENS_FUNCTION void lose(Replica& r, Where const& where, std::uint64_t i, std::uint32_t k, bool touched,
                              Tally& tally) const
    {
        double history[contact::most_state(true)];
        double const* const kept = v.history_of(r.sorted, i, k);
        for (std::uint32_t n = 0; n < v.room.history; ++n)
            history[n] = kept[n];
        std::uint32_t const j = v.neighbour_at(r.sorted, i, k);
        tally.lose(outcome_of_pair<EvaluateAny>(v, r, where, j, history, !touched).lost, 0.5);
    }
};

} // namespace demens::dem::cuda
