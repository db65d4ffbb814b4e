#pragma once

#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Part of the relative spin that rolls: without the twist about the normal.
DEMENS_INLINE DEMENS_FUNCTION Vector3 rolling_spin(ContactKinematics const& contact)
{
    return contact.relative_spin - dot(contact.relative_spin, contact.normal) * contact.normal;
}

//! Elastic-plastic spring-dashpot (type C of Ai et al. 2011): a torque spring k_r = 2.25 S_n mu_r^2 R*^2 up
//! to mu_r R* |F_n|, and below that limit a dashpot -2 eta sqrt(I_r k_r) w. Where the stiffness falls, as
//! that of `hertz` does in unloading, the stored torque falls with it, so that it gives back no more than it
//! took (as Thornton et al. 2013 for Mindlin's).
class EpsdRolling : public LawTraits
{
  public:
    //! Spring torque of the previous step [N m].
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;
    static constexpr bool has_dashpot = true;

    EpsdRolling(PairMaterial const&, PairProperties const& pair)
        : coefficient_(pair.rolling_friction), damping_(pair.rolling_damping),
          softens_(pair.normal == NormalLaw::hertz ? 1.0 : 0.0)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const arm = coefficient_ * contact.effective_radius;
        double const stiffness = 2.25 * normal.stiffness * arm * arm;
        Vector3 const spin = rolling_spin(contact);
        double const unloads = contact.normal_velocity > 0 ? softens_ * contact.normal_velocity : 0.0;
        double const overlap = contact.overlap > 1e-300 ? contact.overlap : 1e-300;
        double const shrink = std::sqrt(overlap / (overlap + unloads * contact.time_step));
        Vector3 const trial = shrink * turned_into_plane(history.vectors[0], contact.normal) -
                              (stiffness * contact.time_step) * spin;
        double const limit = arm * normal.limit;
        double const share = share_within(norm(trial), limit);
        double const viscous =
            (share < 1 ? 0.0 : -2 * damping_) * std::sqrt(contact.rolling_inertia * stiffness);
        history.vectors[0] = share * trial;
        return {history.vectors[0], viscous * spin,
                spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double coefficient_; //!< mu_r
    double damping_;     //!< eta
    double softens_;     //!< 1: the stiffness goes with the root of the overlap
};

} // namespace demens::contact
