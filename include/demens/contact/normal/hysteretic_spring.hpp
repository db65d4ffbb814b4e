#pragma once

#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Spring that is stiffer in unloading than in loading (Walton and Braun 1986; Moncada et al. 2023, eq. 1-2):
//! K_u = K_l/e^2, and unloading never falls below lambda K_l d. A body's stiffness is its modulus times the
//! particle diameter, the two in series.
class HystereticSpringNormal : public LawTraits
{
  public:
    //! Force [N] and overlap [m] of the previous step.
    static constexpr int state_scalars = 2;
    static constexpr bool has_potential = false;

    HystereticSpringNormal(PairMaterial const& material, PairProperties const& pair)
        : modulus_i_(material.youngs_modulus_i), modulus_j_(material.youngs_modulus_j),
          unloading_ratio_(1 / (pair.restitution * pair.restitution)), floor_(pair.minimum_unloading_fraction)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION NormalResponse operator()(ContactKinematics const& contact,
                                                            NormalResponse const&,
                                                            History const& history) const
    {
        double const k_i = 2 * modulus_i_ * contact.radius_i;
        double const k_j = 2 * modulus_j_ * contact.radius_j;
        double const loading = k_i * k_j / (k_i + k_j);
        double const line = loading * contact.overlap;
        double const step = contact.overlap - history.scalars[1];
        double const trial = history.scalars[0] + unloading_ratio_ * loading * step;
        double const lowest = floor_ * line;
        double const on_loading = trial < line ? trial : line;
        double const on_unloading = on_loading > lowest ? on_loading : lowest;
        double const force = step >= 0 ? on_loading : on_unloading;
        history.scalars[0] = force;
        history.scalars[1] = contact.overlap;
        return {force, force, loading, force, spring_energy(force * force, unloading_ratio_ * loading)};
    }

  private:
    double modulus_i_, modulus_j_; //!< [Pa]
    double unloading_ratio_;       //!< K_u/K_l
    double floor_;                 //!< lambda
};

} // namespace demens::contact
