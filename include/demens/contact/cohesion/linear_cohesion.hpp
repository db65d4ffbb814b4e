#pragma once

#include "demens/contact/law_traits.hpp"

#include <numbers>

namespace demens::contact {

//! Square of the radius of the circle in which the surfaces cut each other at the overlap d [m^2]: Heron's
//! formula with the curvature of j in place of its radius, so that it holds for a plane as well.
DEMENS_INLINE DEMENS_FUNCTION double lens_square(ContactKinematics const& contact, double d)
{
    double const ri = contact.radius_i;
    double const curvature = 1 / contact.effective_radius - 1 / ri;
    double const distance = 1 + (ri - d) * curvature;
    return d * (2 - d * curvature) * (2 * ri - d) * (2 + (2 * ri - d) * curvature) /
           (4 * distance * distance);
}

//! Attraction in proportion to the circle in which the surfaces cut each other, F = -k pi a^2 ("simplified
//! JKR").
class LinearCohesion : public LawTraits
{
  public:
    LinearCohesion(PairMaterial const&, PairProperties const& pair)
        : factor_(std::numbers::pi * pair.cohesion_energy_density)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&, History const&) const
    {
        double const d = contact.overlap, square = lens_square(contact, d);
        // Simpson's rule: exact on a plane, and next to it for overlaps much smaller than the radii.
        double const integral = d / 6 * (4 * lens_square(contact, 0.5 * d) + square);
        return {-factor_ * square, -factor_ * integral, 0};
    }

  private:
    double factor_; //!< pi k [J/m^3]
};

} // namespace demens::contact
