#pragma once

#include "demens/contact/evaluation/history_access.hpp"
#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Friction. The ledger keeps the stored energy [J] after the law's scalars, and after its vector the viscous
//! force [N] of a law with a dashpot and the spring's force [N] where the law's history is not that.
template <class Law, bool ledger>
struct TangentialStage
{
    static_assert(Law::state_vectors == 1, "a displacement or a force in the contact plane");
    static constexpr int scalars = Law::state_scalars + (ledger ? 1 : 0);
    static constexpr int vectors =
        1 + (ledger ? (Law::history_is_load ? 0 : 1) + (Law::has_dashpot ? 1 : 0) : 0);

    Law law;
    int scalars_at, vectors_at; //!< where its history begins

    struct Result
    {
        Vector3 force;            //!< on i [N]
        double lost_in_dashpot{}; //!< [J]; with the ledger
        double lost_in_slip{};    //!< [J]; with the ledger
    };

    template <class State>
    DEMENS_INLINE DEMENS_FUNCTION Result operator()(ContactKinematics const& contact,
                                                    NormalResponse const& load, State const& state) const
    {
        constexpr int n = Law::state_scalars;
        double own[n + 1];
        load_scalars<n>(state, scalars_at, own);
        Vector3 const old_history = load_vector(state, vectors_at);
        Vector3 history = old_history;
        Resistance const response = law(contact, load, {own, &history});
        store_scalars<n>(state, scalars_at, own);
        store_vector(state, vectors_at, history);
        Result result{response.spring + response.viscous};
        if constexpr (ledger) {
            Vector3 const path = 0.5 * contact.time_step * contact.tangent_velocity;
            int extra = vectors_at + 3;
            if constexpr (Law::has_dashpot) {
                result.lost_in_dashpot =
                    -dot(exchange(state, extra, response.viscous) + response.viscous, path);
                extra += 3;
            }
            Vector3 old_spring = old_history;
            if constexpr (!Law::history_is_load)
                old_spring = exchange(state, extra, response.spring);
            double const old_stored = exchange(state, scalars_at + n, response.stored);
            result.lost_in_slip = old_stored - response.stored - dot(old_spring + response.spring, path);
        }
        return result;
    }
};

} // namespace demens::contact
