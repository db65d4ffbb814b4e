#pragma once

#include "demens/contact/rolling/epsd.hpp"

namespace demens::contact {

//! Torque in proportion to the rolling velocity, M = -d_R |F_n| R* w without the twist about the normal; d_R
//! is a time (Brilliantov and Poeschel 1998). It never turns the spin round within a step.
class ViscousRolling
{
  public:
    static constexpr int state_vectors = 0;

    ViscousRolling(PairMaterial const&, PairProperties const& pair) : viscosity_(pair.rolling_viscosity) {}

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal, Vector3*) const
    {
        double const resisting = viscosity_ * normal.limit * contact.effective_radius;
        double const stopping = contact.rolling_inertia / contact.time_step;
        double const scale = resisting < stopping ? -resisting : -stopping;
        return {scale * rolling_spin(contact)};
    }

  private:
    double viscosity_; //!< d_R [s]
};

} // namespace demens::contact
