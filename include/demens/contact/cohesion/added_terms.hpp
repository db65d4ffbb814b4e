#pragma once

#include "demens/contact/cohesion/capillary.hpp"
#include "demens/contact/cohesion/linear_cohesion.hpp"
#include "demens/contact/range.hpp"

#include <cmath>
#include <numbers>

namespace demens::contact {

//! What adds to whatever cohesion law a pair has: a sum of terms, each in proportion to an amplitude of its
//! own, which may be 0, so that a force that a model lacks grows into it from nothing.
//!
//! - Area: -k pi a^2, as LinearCohesion.
//! - Surface: -4 pi gamma R* in contact and up to the gap g_0, beyond that falling with the square of the gap
//!   until 1 % of it, as VanDerWaalsCohesion with the Hamaker constant 24 pi gamma g_0^2; with g_0 = 0 as
//!   DmtCohesion.
//! - Bridge: as CapillaryCohesion with the volume v R*^3 and a contact angle of 0.
//! - Charge: 8 pi p (R_i R_j)^2 (1/r^2 - 1/r_c^2) over the distance r of the centres: Coulomb's force of
//! evenly
//!   charged spheres, p = s_i s_j/(2 epsilon_0) for s of charge per area, capped at contact by the bodies'
//!   own size and shifted to 0 at the gap c R*. Positive p pushes. Against a wall the other charge is that of
//!   a like sphere behind it.
class AddedCohesion : public LawTraits
{
  public:
    //! Bridged (0 or 1).
    static constexpr int state_scalars = 1;
    static constexpr bool may_push = true;

    AddedCohesion(PairMaterial const&, PairProperties const& pair)
        : area_(std::numbers::pi * pair.added_energy_density),
          surface_(4 * std::numbers::pi * pair.added_surface_energy), nearest_(pair.added_surface_gap),
          furthest_(pair.added_surface_energy > 0 ? nearest_ / cut_off_root : 0.0),
          bridge_(4 * std::numbers::pi * pair.added_surface_tension),
          bridge_scale_(std::sqrt(2 / pair.added_bridge_volume)),
          rupture_(pair.added_surface_tension > 0 ? std::cbrt(pair.added_bridge_volume) : 0.0),
          charge_(8 * std::numbers::pi * pair.added_charge_pressure),
          charge_reach_(pair.added_charge_pressure != 0 ? pair.added_charge_reach : 0.0)
    {
    }

    //! Whether there is any term.
    static bool is_any(PairProperties const& pair)
    {
        return pair.added_energy_density > 0 || pair.added_surface_energy > 0 ||
               pair.added_surface_tension > 0 || pair.added_charge_pressure != 0;
    }

    //! How far the terms act, for effective radii up to `radius` [m].
    Range reach(double radius) const
    {
        double const everywhere = std::fmax(furthest_, charge_reach_ * radius);
        return {std::fmax(everywhere, rupture_ * radius), !(everywhere > 0)};
    }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&,
                                                              History const& history) const
    {
        Term const area = area_term(contact), surface = surface_term(contact), charge = charge_term(contact);
        double const was = history.scalars[0];
        bool const near =
            contact.overlap > 0 || (was > 0 && contact.gap < rupture_ * contact.effective_radius);
        double const bridged = rupture_ > 0 && near ? 1.0 : 0.0;
        history.scalars[0] = bridged;
        // From here to where it ruptures; that much is lost in the liquid when it forms.
        double const unit = bridge_ * contact.effective_radius * contact.effective_radius / bridge_scale_;
        double const whole = unit * bridge_integral(bridge_scale_ * rupture_);
        double const s = bridge_scale_ * contact.gap / contact.effective_radius;
        double const bridge = bridged * bridge_ * contact.effective_radius / (1 + 1.05 * s + 2.5 * s * s);
        double const stored = bridged * (unit * bridge_integral(s) - whole - bridge * contact.overlap);
        return {area.force + surface.force + charge.force - bridge,
                area.stored + surface.stored + charge.stored + stored, bridged > was ? whole : 0.0};
    }

  private:
    static constexpr double cut_off_root = 0.1; //!< root of the share of the force at which it is cut off

    struct Term
    {
        double force, stored; //!< [N], [J]
    };

    DEMENS_INLINE DEMENS_FUNCTION Term area_term(ContactKinematics const& contact) const
    {
        double const d = contact.overlap, square = lens_square(contact, d);
        double const integral = d / 6 * (4 * lens_square(contact, 0.5 * d) + square); // as LinearCohesion
        return {-area_ * square, -area_ * integral};
    }

    DEMENS_INLINE DEMENS_FUNCTION Term surface_term(ContactKinematics const& contact) const
    {
        bool const acts = contact.overlap > 0 || contact.gap < furthest_;
        double const whole = acts ? surface_ * contact.effective_radius : 0.0;
        double const gap = contact.gap > nearest_ ? contact.gap : nearest_;
        double const share = nearest_ / (gap > 1e-300 ? gap : 1e-300);
        bool const in_contact = !(contact.gap > nearest_);
        double const force = in_contact ? whole : whole * share * share;
        double const outside = whole * nearest_ * (share - cut_off_root); // from the cut-off to the gap
        double const inside = in_contact ? whole * (nearest_ - contact.gap + contact.overlap) : 0.0;
        return {-force, -(nearest_ > 0 ? outside : 0.0) - inside};
    }

    DEMENS_INLINE DEMENS_FUNCTION Term charge_term(ContactKinematics const& contact) const
    {
        double const touch = contact.radius_i + contact.radius_j;
        double const r = touch + contact.gap - contact.overlap;
        double const last = touch + charge_reach_ * contact.effective_radius;
        double const product = contact.radius_i * contact.radius_j;
        double const factor = r < last ? charge_ * product * product : 0.0;
        double const per_r = 1 / r, per_last = 1 / last;
        return {factor * (per_r * per_r - per_last * per_last),
                factor * (per_r - per_last - (last - r) * per_last * per_last)};
    }

    double area_;         //!< pi k [J/m^3]
    double surface_;      //!< 4 pi gamma [J/m^2]
    double nearest_;      //!< g_0 [m]
    double furthest_;     //!< where the surface term is cut off [m]
    double bridge_;       //!< 4 pi sigma [N/m]
    double bridge_scale_; //!< sqrt(2/v)
    double rupture_;      //!< gap over effective radius at which a bridge ruptures [-]
    double charge_;       //!< 8 pi p [Pa]
    double charge_reach_; //!< c [-]
};

} // namespace demens::contact
