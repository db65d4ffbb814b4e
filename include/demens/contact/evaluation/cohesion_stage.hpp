#pragma once

#include "demens/contact/evaluation/history_access.hpp"
#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Attraction, or what else acts along the normal without touching. The ledger keeps its potential [J] after
//! the law's scalars.
template <class Law, bool ledger>
struct CohesionStage
{
    static_assert(Law::state_vectors == 0, "a force along the normal remembers no direction");
    static constexpr int scalars = Law::state_scalars + (ledger ? 1 : 0);
    static constexpr int vectors = 0;

    Law law;
    int scalars_at;        //!< where its history begins
    double share_in_limit; //!< of the force in the limit of friction and rolling: 0 or 1

    struct Result
    {
        double force; //!< along the normal on i [N]
        double limit; //!< of friction and rolling [N]
        double lost;  //!< to bonds that form or break [J]; with the ledger
    };

    //! `load` is what the normal stage has made.
    template <class State>
    DEMENS_INLINE DEMENS_FUNCTION Result operator()(ContactKinematics const& contact,
                                                    NormalResponse const& load, State const& state) const
    {
        constexpr int n = Law::state_scalars;
        double own[n + 1];
        load_scalars<n>(state, scalars_at, own);
        CohesionResponse const response = law(contact, load, {own, nullptr});
        store_scalars<n>(state, scalars_at, own);
        if constexpr (ledger)
            state[scalars_at + n] = response.stored;
        // What pushes without touching presses nothing on anything.
        double const pull = Law::may_push && response.force > 0 ? 0.0 : response.force;
        double const limit = load.limit + share_in_limit * pull;
        return {response.force, limit > 0 ? limit : 0.0, ledger ? response.lost : 0.0};
    }
};

} // namespace demens::contact
