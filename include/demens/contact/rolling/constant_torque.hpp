#pragma once

#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Torque of constant size against the relative spin, M = -mu_r R* |F_n| w/|w| (type A of Ai et al. 2011). It
//! never turns the spin round within a step: |M| <= I_r |w|/dt, which lets a body come to rest.
class ConstantTorqueRolling : public LawTraits
{
  public:
    ConstantTorqueRolling(PairMaterial const&, PairProperties const& pair)
        : coefficient_(pair.rolling_friction)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal, History const&) const
    {
        double const spin = norm(contact.relative_spin);
        double const limit = coefficient_ * contact.effective_radius * normal.limit;
        double const resisting = limit / (spin > 1e-300 ? spin : 1e-300);
        double const stopping = contact.rolling_inertia / contact.time_step;
        double const scale = resisting < stopping ? -resisting : -stopping;
        return {scale * contact.relative_spin};
    }

  private:
    double coefficient_; //!< mu_r
};

} // namespace demens::contact
