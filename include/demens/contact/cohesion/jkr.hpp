#pragma once

#include "demens/contact/law_traits.hpp"

#include <cmath>
#include <numbers>

namespace demens::contact {

//! Cube root of a length in metres, 1e-9 to 10, from square roots and three steps of Halley's method: as
//! std::cbrt, but it vectorises.
DEMENS_INLINE DEMENS_FUNCTION double cube_root(double length)
{
    double const fourth = std::sqrt(std::sqrt(length));
    double root = fourth * std::sqrt(std::sqrt(fourth)); // 1/4 + 1/16 is almost 1/3
    for (int k = 0; k < 3; ++k) {
        double const cube = root * root * root;
        root *= (cube + 2 * length) / (2 * cube + length);
    }
    return root;
}

//! Adhesion of soft elastic spheres (Johnson, Kendall and Roberts 1971), as what it adds to Hertz: with the
//! contact radius a, F = -4 E* a^3/(3 R*) + 4 sqrt(pi gamma E* a^3), d = a^2/R* - 2 sqrt(pi gamma a/E*). It
//! pulls with up to 3 pi gamma R*. The bond forms at contact and breaks at the gap 3 a_s^2/R*, beyond which
//! there is no equilibrium, a_s^3 = pi gamma R*^2/(4 E*).
class JkrCohesion : public LawTraits
{
  public:
    //! Bonded (0 or 1).
    static constexpr int state_scalars = 1;

    JkrCohesion(PairMaterial const& material, PairProperties const& pair)
        : modulus_(material.effective_youngs_modulus), bonds_(pair.surface_energy > 0 ? 1.0 : 0.0),
          breaking_(std::cbrt(std::numbers::pi * (pair.surface_energy > 0 ? pair.surface_energy : 1.0) /
                              (4 * modulus_)))
    {
    }

    //! Gap at which bonds of this effective radius break [m].
    double range(double effective_radius) const
    {
        return 3 * bonds_ * breaking_ * breaking_ * std::cbrt(effective_radius);
    }

    DEMENS_INLINE DEMENS_FUNCTION CohesionResponse operator()(ContactKinematics const& contact,
                                                              NormalResponse const&,
                                                              History const& history) const
    {
        double const radius = contact.effective_radius;
        double const third = cube_root(radius);
        double const smallest = breaking_ * third * third;
        double const reach = 3 * breaking_ * breaking_ * third;
        double const depth = (contact.overlap - contact.gap) / reach;
        double const was = history.scalars[0];
        double const bonded = contact.overlap > 0 || (was > 0 && depth > -1) ? bonds_ : 0.0;
        history.scalars[0] = bonded;
        double const y = root_of_contact_radius(depth);
        double const y3 = y * y * y;
        double const unit = modulus_ * smallest * smallest * smallest / radius; // E* a_s^3/R*
        double const hertz = 4.0 / 3 * modulus_ * contact.contact_radius * contact.overlap;
        double const force = bonded * (unit * (8 * y3 - 4.0 / 3 * y3 * y3) + hertz);
        double const energy_unit = unit * smallest * smallest / radius;
        double const stored =
            bonded * (energy_unit * (potential(y) - potential(1.0)) - 0.4 * hertz * contact.overlap);
        double const formed = bonded > was ? 1.0 : 0.0;
        constexpr double at_touch = 1.5874010519681996; // y at d = 0: 4^(1/3)
        double const lost = formed * energy_unit * (potential(1.0) - potential(at_touch));
        return {-force, stored, lost};
    }

  private:
    //! sqrt(a/a_s) at the overlap D in units of the breaking gap: the larger root of y^4 - 4 y = 3 D. With
    //! z = y - 1 that is z sqrt(z^2 + 4 z + 6) = sqrt(3 (D + 1)), which Newton's method solves everywhere.
    DEMENS_INLINE DEMENS_FUNCTION static double root_of_contact_radius(double depth)
    {
        double const above = depth > -1 ? 3 * (depth + 1) : 0.0;
        double const w = std::sqrt(above);
        double z = 2 * w / (2.449489742783178 + std::sqrt(6 + 4 * w));
        for (int k = 0; k < 3; ++k) {
            double const square = z * z + 4 * z + 6;
            double const root = std::sqrt(square);
            z -= (z * root - w) * root / (2 * (z * z + 3 * z + 3));
        }
        return 1 + z;
    }

    //! Energy in units of E* a_s^5/R*^2: integral of the JKR force over the overlap.
    DEMENS_INLINE DEMENS_FUNCTION static constexpr double potential(double y)
    {
        double const y3 = y * y * y;
        return y3 * y * (8.0 / 15 * y3 * y3 - 16.0 / 3 * y3 + 8);
    }

    double modulus_;  //!< E* [Pa]
    double bonds_;    //!< 0 without surface energy, else 1
    double breaking_; //!< a_s/R*^(2/3) [m^(1/3)]
};

} // namespace demens::contact
