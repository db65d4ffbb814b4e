#pragma once

#include "demens/contact/law_traits.hpp"

#include <cmath>
#include <numbers>

namespace demens::contact {

//! Integral of 1/(1 + 1.05 s + 2.5 s^2), the force of a bridge over its scaled gap, from 0.
DEMENS_INLINE DEMENS_FUNCTION double bridge_integral(double s)
{
    constexpr double root = 2.982867747654931;
    return 2 / root * (std::atan((5 * s + 1.05) / root) - std::atan(1.05 / root));
}

//! Liquid bridge of a given volume V: F = -4 pi R* sigma cos(theta)/(1 + 1.05 S + 2.5 S^2) over the gap g
//! with S = g sqrt(2 R*/V) (Willett et al. 2000, for unlike spheres with Derjaguin's radius 2 R*). The bridge
//! forms at contact and ruptures at the gap (1 + theta/2) V^(1/3) (Lian et al. 1993).
class CapillaryCohesion : public LawTraits
{
  public:
    //! Bridged (0 or 1).
    static constexpr int state_scalars = 1;

    CapillaryCohesion(PairMaterial const&, PairProperties const& pair)
        : factor_(4 * std::numbers::pi * pair.surface_tension *
                  std::cos(pair.contact_angle_deg * std::numbers::pi / 180)),
          inverse_volume_(2 / (pair.bridge_volume > 0 ? pair.bridge_volume : 1.0)),
          rupture_((1 + 0.5 * pair.contact_angle_deg * std::numbers::pi / 180) *
                   std::cbrt(pair.bridge_volume))
    {
    }

    //! Gap at which a bridge ruptures [m].
    double range(double) const { return rupture_; }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&,
                                                              History const& history) const
    {
        double const was = history.scalars[0];
        bool const wet = rupture_ > 0;
        double const bridged =
            wet && (contact.overlap > 0 || (was > 0 && contact.gap < rupture_)) ? 1.0 : 0.0;
        history.scalars[0] = bridged;
        double const radius = contact.effective_radius;
        double const scale = std::sqrt(radius * inverse_volume_);
        double const s = scale * contact.gap;
        double const force = bridged * factor_ * radius / (1 + 1.05 * s + 2.5 * s * s);
        double const whole = factor_ * radius / scale * bridge_integral(scale * rupture_);
        double const stored = factor_ * radius / scale * bridge_integral(s) - whole - force * contact.overlap;
        return {-force, bridged * stored, bridged > was ? whole : 0.0};
    }

  private:
    double factor_;         //!< 4 pi sigma cos(theta) [N/m]
    double inverse_volume_; //!< 2/V [1/m^3]
    double rupture_;        //!< [m]
};

} // namespace demens::contact
