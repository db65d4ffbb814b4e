#pragma once

#include "demens/contact/friction.hpp"

namespace demens::contact {

//! Mindlin's no-slip spring on the whole tangential displacement, F_t = -S_t s, S_t = 8 G* sqrt(R* d), with a
//! Coulomb limit, at which s is scaled back, and the damping 2 sqrt(5/6) beta sqrt(S_t m*) v_t while it
//! sticks (Mindlin 1949; Tsuji et al. 1992). The stiffness follows the overlap while s stays, which creates
//! energy in loading: `mindlin_rescale` does not.
template <class Friction>
class MindlinTangentialWith : public LawTraits
{
  public:
    //! Sliding (0 or 1), tangential displacement [m].
    static constexpr int state_scalars = 1;
    static constexpr int state_vectors = 1;
    static constexpr bool has_dashpot = true;

    MindlinTangentialWith(PairMaterial const& material, PairProperties const& pair)
        : shear_modulus_(material.effective_shear_modulus),
          damping_(1.8257418583505538 * material.damping * std::sqrt(8 * shear_modulus_)),
          friction_(friction_of<Friction>(pair))
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const stiffness = 8 * shear_modulus_ * contact.contact_radius;
        Vector3 const trial = turned_into_plane(history.vectors[0], contact.normal) +
                              contact.time_step * contact.tangent_velocity;
        history.vectors[0] =
            friction_.in(contact).limit(stiffness * norm(trial), normal.limit, history.scalars[0]) * trial;
        double const sticks = normal.limit > 0 ? 1 - history.scalars[0] : 0.0; // a pull holds nothing
        double const viscous = sticks * damping_ * contact.damping_scale;
        return {-stiffness * history.vectors[0], viscous * contact.tangent_velocity,
                0.5 * stiffness * norm_squared(history.vectors[0])};
    }

  private:
    double shear_modulus_; //!< G* [Pa]
    double damping_;       //!< 2 sqrt(5/6) beta sqrt(8 G*) [Pa^(1/2)]
    Friction friction_;
};

using MindlinTangential = MindlinTangentialWith<CoulombFriction>;

} // namespace demens::contact
