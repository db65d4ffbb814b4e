#pragma once

#include "demens/contact/friction.hpp"

namespace demens::contact {

//! Linear spring with a Coulomb limit, F_t = F_t,old - K_t ds_t (Moncada et al. 2023, eq. 3-4); K_t is a
//! ratio of the normal stiffness. Where that falls, as the tangent stiffness of `hertz` does in unloading,
//! the stored force falls with it, so that F_t^2/(2 K_t) does not grow (as Thornton et al. 2013 for
//! Mindlin's).
template <class Friction>
class LinearCoulombTangentialWith : public LawTraits
{
  public:
    //! Sliding (0 or 1), stiffness [N/m] and force [N] of the previous step.
    static constexpr int state_scalars = 2;
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;

    LinearCoulombTangentialWith(PairMaterial const&, PairProperties const& pair)
        : stiffness_ratio_(pair.tangential_stiffness_ratio), friction_(friction_of<Friction>(pair))
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const stiffness = stiffness_ratio_ * normal.stiffness;
        double const old = history.scalars[1] > 0 ? history.scalars[1] : stiffness;
        history.scalars[1] = stiffness;
        bool const softens = stiffness < old;
        double const shrink = softens ? stiffness / old : 1.0;
        // In loading the stiffness of the middle of the step, in unloading that to which the force has
        // shrunk.
        double const mean = softens ? stiffness : 0.5 * (old + stiffness);
        Vector3 const trial = shrink * turned_into_plane(history.vectors[0], contact.normal) -
                              (mean * contact.time_step) * contact.tangent_velocity;
        history.vectors[0] =
            friction_.in(contact).limit(norm(trial), normal.limit, history.scalars[0]) * trial;
        return {history.vectors[0], {}, spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double stiffness_ratio_; //!< K_t/K_l
    Friction friction_;
};

using LinearCoulombTangential = LinearCoulombTangentialWith<CoulombFriction>;

} // namespace demens::contact
