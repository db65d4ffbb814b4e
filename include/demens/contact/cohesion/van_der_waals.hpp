#pragma once

#include "demens/contact/law_traits.hpp"

#include <cmath>
#include <numbers>

namespace demens::contact {

//! Van der Waals attraction: -A R*/(6 g^2) over the gap g, constant below the gap g_0 at which it reaches the
//! contact force -4 pi gamma R*, and cut off at g_0/sqrt(C), C = 0.01, where it has fallen to C of that
//! (Meier et al. 2019). In contact it is `dmt`.
class VanDerWaalsCohesion : public LawTraits
{
  public:
    static constexpr bool needs_contact = false;

    VanDerWaalsCohesion(PairMaterial const&, PairProperties const& pair)
        : factor_(pair.surface_energy > 0 ? pair.hamaker_constant / 6 : 0.0),
          nearest_(pair.surface_energy > 0
                       ? std::sqrt(pair.hamaker_constant / (24 * std::numbers::pi * pair.surface_energy))
                       : 0.0)
    {
    }

    //! Gap at which it is cut off [m].
    double range(double) const { return nearest_ / cut_off_root; }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&, History const&) const
    {
        double const last = nearest_ / cut_off_root;
        double const gap = contact.gap > nearest_ ? contact.gap : nearest_;
        double const factor = contact.gap < last ? factor_ * contact.effective_radius : 0.0;
        double const inverse = 1 / (gap > 1e-300 ? gap : 1e-300);
        double const force = -factor * inverse * inverse;
        // From the cut-off to the gap, and on at constant force to where the body is.
        double const beyond = last > 1e-300 ? 1 / last : 0.0;
        double const stored = -factor * (inverse - beyond) + force * (gap - contact.gap + contact.overlap);
        return {force, stored, 0};
    }

  private:
    static constexpr double cut_off_root = 0.1; //!< sqrt(C)

    double factor_;  //!< A/6 [J]
    double nearest_; //!< g_0 [m]
};

} // namespace demens::contact
