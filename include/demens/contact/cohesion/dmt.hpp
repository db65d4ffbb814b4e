#pragma once

#include "demens/contact/law_traits.hpp"

#include <numbers>

namespace demens::contact {

//! Constant attraction in contact, F = -4 pi gamma R*, which is also the pull-off force (Derjaguin, Muller
//! and Toporov 1975); gamma is the surface energy of either body.
class DmtCohesion : public LawTraits
{
  public:
    DmtCohesion(PairMaterial const&, PairProperties const& pair)
        : factor_(4 * std::numbers::pi * pair.surface_energy)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&, History const&) const
    {
        double const force = contact.overlap > 0 ? -factor_ * contact.effective_radius : 0.0;
        return {force, force * contact.overlap, 0};
    }

  private:
    double factor_; //!< 4 pi gamma [J/m^2]
};

} // namespace demens::contact
