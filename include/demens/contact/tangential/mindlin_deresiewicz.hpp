#pragma once

#include "demens/contact/friction.hpp"

namespace demens::contact {

//! Spring that softens as slip spreads over the contact, F_t = -mu F_n [1 - (1 - |s|/s_max)^(3/2)] s/|s| with
//! s_max = mu (2 - nu)/(2 (1 - nu)) d = mu E*/(4 G*) d, and the damping of Mindlin's law while it sticks
//! (Mindlin and Deresiewicz 1953; Langston et al. 1995). A contact that slides is held where this curve of
//! static friction passes the kinetic force.
template <class Friction>
class MindlinDeresiewiczTangentialWith : public LawTraits
{
  public:
    //! Sliding (0 or 1), tangential displacement [m].
    static constexpr int state_scalars = 1;
    static constexpr int state_vectors = 1;
    static constexpr bool has_dashpot = true;

    MindlinDeresiewiczTangentialWith(PairMaterial const& material, PairProperties const& pair)
        : friction_(pair.static_friction),
          largest_per_overlap_(pair.static_friction * material.effective_youngs_modulus /
                               (4 * material.effective_shear_modulus)),
          damping_(1.8257418583505538 * material.damping * std::sqrt(8 * material.effective_shear_modulus)),
          slip_(friction_of<Friction>(pair)), coulomb_slip_(slip_limits(slip_))
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const largest = largest_per_overlap_ * contact.overlap;
        Vector3 const trial = turned_into_plane(history.vectors[0], contact.normal) +
                              contact.time_step * contact.tangent_velocity;
        double const size = norm(trial);
        double const share = slip_in(contact).limit(size, largest, history.scalars[0]);
        history.vectors[0] = share * trial;
        double const slid = share * size / (largest > 1e-300 ? largest : 1e-300);
        double const left = slid < 1 ? 1 - slid : 0.0;
        double const root = std::sqrt(left);
        double const force = friction_ * normal.limit * (1 - left * root);
        double const sticks = normal.limit > 0 ? 1 - history.scalars[0] : 0.0; // a pull holds nothing
        double const viscous = sticks * damping_ * contact.damping_scale;
        return {-force / (share * size > 1e-300 ? share * size : 1e-300) * history.vectors[0],
                viscous * contact.tangent_velocity,
                friction_ * normal.limit * largest * (slid - 0.4 * (1 - left * left * root))};
    }

  private:
    //! Limits of |s|/s_max: sliding, it is held where the curve passes the kinetic force.
    template <class Coefficients>
    DEMENS_INLINE DEMENS_FUNCTION static CoulombFriction slip_limits(Coefficients const& friction)
    {
        double const ratio = friction.static_coefficient > 0
                                 ? friction.kinetic_coefficient / friction.static_coefficient
                                 : 1.0;
        return {1.0, 1 - std::cbrt((1 - ratio) * (1 - ratio))};
    }
    DEMENS_INLINE DEMENS_FUNCTION CoulombFriction slip_in(ContactKinematics const& contact) const
    {
        if constexpr (std::is_same_v<Friction, CoulombFriction>)
            return coulomb_slip_;
        else
            return slip_limits(slip_.in(contact));
    }

    double friction_;            //!< mu_s
    double largest_per_overlap_; //!< s_max/d
    double damping_;             //!< 2 sqrt(5/6) beta sqrt(8 G*) [Pa^(1/2)]
    Friction slip_;
    CoulombFriction coulomb_slip_; //!< limits of |s|/s_max, where they are the same for all contacts
};
using MindlinDeresiewiczTangential = MindlinDeresiewiczTangentialWith<CoulombFriction>;

} // namespace demens::contact
