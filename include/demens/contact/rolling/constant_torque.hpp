#pragma once

#include "demens/contact/rolling/epsd.hpp"

namespace demens::contact {

//! Torque of constant size against the relative spin, M = -mu_r R* |F_n| w/|w| (type A of Ai et al. 2011),
//! twist included. At rest it holds whatever is below that: a spring as stiff as the time step allows,
//! k_r = I_s/(6 dt)^2 with I_s = (1/m_i R_i^2 + 1/m_j R_j^2)^-1 2/5, and a dashpot of .3 of the critical one
//! while it does, both together within the limit. A body that its contacts must stop by its own moment of
//! inertia only stays stable with 16 of them.
class ConstantTorqueRolling : public LawTraits
{
  public:
    //! Spring torque of the previous step [N m].
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;
    static constexpr bool has_dashpot = true;

    ConstantTorqueRolling(PairMaterial const&, PairProperties const& pair)
        : coefficient_(pair.rolling_friction)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        constexpr double steps = 6, share_of_critical = 0.3;
        // A spinning body has 2/7 of its moment of inertia about the contact point.
        double const impulse = 2.0 / 7 * contact.rolling_inertia / (steps * contact.time_step);
        double const stiffness = impulse / (steps * contact.time_step);
        double const limit = coefficient_ * contact.effective_radius * normal.limit;
        Vector3 const trial = history.vectors[0] - (impulse / steps) * contact.relative_spin;
        double const share = share_within(norm(trial), limit);
        Vector3 const spring = share * trial;
        double const damping = share < 1 ? 0.0 : 2 * share_of_critical * impulse;
        Vector3 const viscous = -damping * contact.relative_spin;
        double const within = share_within(norm(spring + viscous), limit);
        history.vectors[0] = within * spring;
        return {history.vectors[0], within * viscous,
                spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double coefficient_; //!< mu_r
};

} // namespace demens::contact
