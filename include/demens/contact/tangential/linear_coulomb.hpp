#pragma once

#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Linear spring with a Coulomb limit, F_t = F_t,old - K_t ds_t (Moncada et al. 2023, eq. 3-4); K_t is a
//! ratio of the normal stiffness.
class LinearCoulombTangential : public LawTraits
{
  public:
    //! Sliding (0 or 1), force of the previous step [N].
    static constexpr int state_scalars = 1;
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;

    LinearCoulombTangential(PairMaterial const&, PairProperties const& pair)
        : stiffness_ratio_(pair.tangential_stiffness_ratio), friction_{pair.static_friction,
                                                                       pair.kinetic_friction}
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const stiffness = stiffness_ratio_ * normal.stiffness;
        Vector3 const trial = turned_into_plane(history.vectors[0], contact.normal) -
                              (stiffness * contact.time_step) * contact.tangent_velocity;
        history.vectors[0] = friction_.limit(norm(trial), normal.limit, history.scalars[0]) * trial;
        return {history.vectors[0], {}, spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double stiffness_ratio_; //!< K_t/K_l
    CoulombFriction friction_;
};

} // namespace demens::contact
