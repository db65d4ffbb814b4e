#pragma once

#include "demens/contact/evaluation/history_access.hpp"
#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Rolling resistance. The ledger keeps the stored energy [J] after the law's scalars, and the torque [N m]
//! after its vectors where the law's history is not that.
template <class Law, bool ledger>
struct RollingStage
{
    static_assert(Law::state_vectors <= 1, "at most a torque or an angle");
    static constexpr int scalars = Law::state_scalars + (ledger ? 1 : 0);
    static constexpr bool keeps_torque = ledger && !(Law::history_is_load && !Law::has_dashpot);
    static constexpr int vectors = Law::state_vectors + (keeps_torque ? 1 : 0);

    Law law;
    int scalars_at, vectors_at; //!< where its history begins

    struct Result
    {
        Vector3 torque; //!< on i [N m]
        double lost{};  //!< [J]; with the ledger
    };

    template <class State>
    DEMENS_INLINE DEMENS_FUNCTION Result operator()(ContactKinematics const& contact,
                                                    NormalResponse const& load, State const& state) const
    {
        constexpr int n = Law::state_scalars;
        double own[n + 1];
        load_scalars<n>(state, scalars_at, own);
        Vector3 old_history;
        if constexpr (Law::state_vectors > 0)
            old_history = load_vector(state, vectors_at);
        Vector3 history = old_history;
        Resistance const response = law(contact, load, {own, &history});
        store_scalars<n>(state, scalars_at, own);
        if constexpr (Law::state_vectors > 0)
            store_vector(state, vectors_at, history);
        Result result{response.spring + response.viscous};
        if constexpr (ledger) {
            Vector3 const turn = 0.5 * contact.time_step * contact.relative_spin;
            Vector3 old_torque = old_history;
            if constexpr (keeps_torque)
                old_torque = exchange(state, vectors_at + 3 * Law::state_vectors, result.torque);
            double const old_stored = exchange(state, scalars_at + n, response.stored);
            result.lost = old_stored - response.stored - dot(old_torque + result.torque, turn);
        }
        return result;
    }
};

} // namespace demens::contact
