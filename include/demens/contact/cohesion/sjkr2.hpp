#pragma once

#include "demens/contact/law_traits.hpp"

#include <numbers>

namespace demens::contact {

//! Linear cohesion with the area of a cap instead of the circle, F = -k 2 pi d (2 R*) ("SJKR2").
class Sjkr2Cohesion : public LawTraits
{
  public:
    Sjkr2Cohesion(PairMaterial const&, PairProperties const& pair)
        : factor_(4 * std::numbers::pi * pair.cohesion_energy_density)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&, History const&) const
    {
        double const force = -factor_ * contact.effective_radius * contact.overlap;
        return {force, 0.5 * force * contact.overlap, 0};
    }

  private:
    double factor_; //!< 4 pi k [J/m^3]
};

} // namespace demens::contact
