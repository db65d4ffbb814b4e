#pragma once

#include "demens/contact/rolling/epsd.hpp"

namespace demens::contact {

//! Torque in proportion to the rolling velocity, M = -d_R |F_n| R* w without the twist about the normal; d_R
//! is a time (Brilliantov and Poeschel 1998). It is bounded by a sixteenth of the torque that would stop the
//! rolling of one contact within a step: all contacts of a particle together, which meet its own moment of
//! inertia only (2/7 of that about a contact), must not turn its spin round. A bed locked by this law would
//! else gain energy.
class ViscousRolling : public LawTraits
{
  public:
    ViscousRolling(PairMaterial const&, PairProperties const& pair) : viscosity_(pair.rolling_viscosity) {}

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal, History const&) const
    {
        double const resisting = viscosity_ * normal.limit * contact.effective_radius;
        double const stopping = contact.rolling_inertia / (16 * contact.time_step);
        double const scale = resisting < stopping ? -resisting : -stopping;
        return {scale * rolling_spin(contact)};
    }

  private:
    double viscosity_; //!< d_R [s]
};

} // namespace demens::contact
