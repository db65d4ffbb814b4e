#pragma once

#include "demens/contact/kinematics.hpp"
#include "demens/contact/pair_material.hpp"

namespace demens::contact {

//! Linear spring with a Coulomb limit, F_t = F_t,old - K_t ds_t (Moncada et al. 2023, eq. 3-4); K_t is a
//! ratio of the normal stiffness.
class LinearCoulombTangential
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
                                                        NormalResponse const& normal, double* scalars,
                                                        Vector3* vectors) const
    {
        double const stiffness = stiffness_ratio_ * normal.stiffness;
        Vector3 const trial = turned_into_plane(vectors[0], contact.normal) -
                              (stiffness * contact.time_step) * contact.tangent_velocity;
        vectors[0] = friction_.limit(norm(trial), normal.limit, scalars[0]) * trial;
        return {vectors[0], {}, spring_energy(norm_squared(vectors[0]), stiffness)};
    }

  private:
    double stiffness_ratio_; //!< K_t/K_l
    CoulombFriction friction_;
};

} // namespace demens::contact
