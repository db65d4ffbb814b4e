#pragma once

#include "demens/contact/evaluation/history_access.hpp"
#include "demens/contact/law_traits.hpp"

namespace demens::contact {

// A stage evaluates one law of a contact: it reads the law's part of the history, calls the law, writes the
// new history, and with the ledger finds what was lost since the step before. Work since then: the bodies
// have moved with the velocities at hand, which are those of the middle of the step, under the mean of the
// old and the new force. That is exactly the change of kinetic energy.

//! Normal force. The ledger keeps the inelastic force [N] and the stored energy [J] after the law's scalars.
template <class Law, bool ledger>
struct NormalStage
{
    static_assert(Law::state_vectors == 0, "a force along the normal remembers no direction");
    static constexpr int scalars = Law::state_scalars + (ledger ? 2 : 0);
    static constexpr int vectors = 0;

    Law law;
    int scalars_at; //!< where its history begins

    struct Result
    {
        NormalResponse response;
        double lost; //!< to damping [J]; with the ledger
    };

    template <class State>
    DEMENS_INLINE DEMENS_FUNCTION Result operator()(ContactKinematics const& contact,
                                                    State const& state) const
    {
        constexpr int n = Law::state_scalars;
        double own[n + 1];
        load_scalars<n>(state, scalars_at, own);
        Result result{law(contact, {}, {own, nullptr}), 0};
        store_scalars<n>(state, scalars_at, own);
        if constexpr (ledger) {
            NormalResponse const& now = result.response;
            double const old_force = exchange(state, scalars_at + n, now.inelastic);
            double const old_stored = exchange(state, scalars_at + n + 1, now.stored);
            double const given_back = Law::has_potential ? 0.0 : old_stored - now.stored;
            result.lost =
                given_back - 0.5 * contact.time_step * contact.normal_velocity * (old_force + now.inelastic);
        }
        return result;
    }
};

} // namespace demens::contact
