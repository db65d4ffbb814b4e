#pragma once

#include "demens/contact/law_traits.hpp"

namespace demens::contact {

//! Two elastic spheres with viscous damping that gives a constant restitution (Hertz 1882; Tsuji et al.
//! 1992): F_n = 4/3 E* sqrt(R*) d^(3/2) + 2 sqrt(5/6) beta sqrt(S_n m*) v_n, S_n = 2 E* sqrt(R* d). Its
//! elastic part limits friction: over an impact that part has the impulse of the whole force, so that a
//! sliding impact has exactly mu times the normal impulse, whatever the damping. On request the whole force
//! does where it pushes, as in other codes. One that relaxes has also the damping of viscoelastic spheres,
//! A S_n v_n (Brilliantov et al. 1996), which lowers the restitution the more, the faster the impact.
template <bool relaxes>
class HertzNormalWith : public LawTraits
{
  public:
    HertzNormalWith(PairMaterial const& material, PairProperties const& pair)
        : youngs_modulus_(material.effective_youngs_modulus),
          damping_(1.8257418583505538 * material.damping * std::sqrt(2 * youngs_modulus_)),
          lowest_(pair.allow_attraction ? -1e300 : 0.0),
          limit_by_damping_(pair.friction_limit == FrictionLimit::whole ? 1.0 : 0.0),
          relaxation_(pair.viscoelastic_time)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION NormalResponse operator()(ContactKinematics const& contact,
                                                            NormalResponse const&, History const&) const
    {
        double const stiffness = 2 * youngs_modulus_ * contact.contact_radius;
        double const elastic = 2.0 / 3.0 * stiffness * contact.overlap;
        double viscous = damping_ * contact.damping_scale * contact.normal_velocity;
        if constexpr (relaxes)
            viscous -= relaxation_ * stiffness * contact.normal_velocity;
        double const total = elastic + viscous;
        double const force = total > lowest_ ? total : lowest_;
        double const pushing = force > 0 ? force : 0.0;
        double const limit = limit_by_damping_ > 0 ? pushing : elastic;
        return {force, limit, stiffness, force - elastic, 0.4 * elastic * contact.overlap};
    }

  private:
    double youngs_modulus_;
    double damping_;          //!< 2 sqrt(5/6) beta sqrt(2 E*) [Pa^(1/2)]
    double lowest_;           //!< smallest force allowed [N]
    double limit_by_damping_; //!< 1: the whole force limits friction
    double relaxation_;       //!< A [s]
};
using HertzNormal = HertzNormalWith<false>;

} // namespace demens::contact
