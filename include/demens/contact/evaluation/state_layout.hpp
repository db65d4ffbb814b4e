#pragma once

#include "demens/contact/evaluation/cohesion_stage.hpp"
#include "demens/contact/evaluation/normal_stage.hpp"
#include "demens/contact/evaluation/rolling_stage.hpp"
#include "demens/contact/evaluation/tangential_stage.hpp"
#include "demens/contact/laws.hpp"

#include <algorithm>
#include <type_traits>

namespace demens::contact {

//! Where each law of a set keeps its history among the doubles of a contact: scalars first, then vectors.
struct StateLayout
{
    int normal = 0, cohesion = 0, added = 0, tangential = 0, rolling = 0; //!< first scalar of each
    int tangential_vector = 0, rolling_vector = 0;                        //!< first component of each
    int scalars = 0;                                                      //!< how many scalars there are
    int size = 0;                                                         //!< in all, in whole fours
    bool ledger = false; //!< room for what the energy ledger compares with the step before
};
StateLayout state_layout(LawSet const& laws, bool ledger);

//! Numbers of history that a stage keeps for a law.
struct StateSize
{
    int scalars = 0, vectors = 0;

    constexpr int total() const { return scalars + 3 * vectors; }
};
template <template <class, bool> class Stage, class Law>
constexpr StateSize state_size(bool ledger)
{
    if constexpr (std::is_same_v<Law, NoLaw>)
        return {};
    else if (ledger)
        return {Stage<Law, true>::scalars, Stage<Law, true>::vectors};
    else
        return {Stage<Law, false>::scalars, Stage<Law, false>::vectors};
}

//! Doubles in whole fours.
constexpr int whole_fours(int doubles)
{
    return (doubles + 3) / 4 * 4;
}

//! The layout of stages that keep so much.
constexpr StateLayout state_layout(StateSize normal, StateSize cohesion, StateSize added,
                                   StateSize tangential, StateSize rolling, bool ledger)
{
    StateLayout layout{.ledger = ledger};
    int next = 0;
    auto const place = [&](int& at, int size) {
        at = next;
        next += size;
    };
    place(layout.normal, normal.scalars);
    place(layout.cohesion, cohesion.scalars);
    place(layout.added, added.scalars);
    place(layout.tangential, tangential.scalars);
    place(layout.rolling, rolling.scalars);
    layout.scalars = next;
    place(layout.tangential_vector, 3 * tangential.vectors);
    place(layout.rolling_vector, 3 * rolling.vectors);
    layout.size = whole_fours(next);
    return layout;
}

//! Most numbers of history of any law of a kind.
template <template <class, bool> class Stage, class Any>
struct MostState;
template <template <class, bool> class Stage, class... Laws>
struct MostState<Stage, OneOf<Laws...>>
{
    static constexpr int with(bool ledger) { return std::max({state_size<Stage, Laws>(ledger).total()...}); }
};

//! Size of the largest layout that any set of laws has.
constexpr int most_state(bool ledger)
{
    return whole_fours(MostState<NormalStage, AnyNormal>::with(ledger) +
                       MostState<CohesionStage, AnyCohesion>::with(ledger) +
                       MostState<CohesionStage, AnyAdded>::with(ledger) +
                       MostState<TangentialStage, AnyTangential>::with(ledger) +
                       MostState<RollingStage, AnyRolling>::with(ledger));
}

//! Energy that contacts hold [J].
struct StoredEnergy
{
    double normal = 0, tangential = 0, rolling = 0, cohesive = 0;

    double total() const { return normal + tangential + rolling + cohesive; }
    StoredEnergy& operator+=(StoredEnergy const& other)
    {
        normal += other.normal, tangential += other.tangential;
        rolling += other.rolling, cohesive += other.cohesive;
        return *this;
    }
    friend StoredEnergy operator*(double factor, StoredEnergy const& e)
    {
        return {factor * e.normal, factor * e.tangential, factor * e.rolling, factor * e.cohesive};
    }
};
//! What the history of one contact says; its layout must have room for the ledger.
StoredEnergy stored_energy(LawSet const& laws, StateLayout const& layout, double const* state);

} // namespace demens::contact
