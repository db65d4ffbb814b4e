#pragma once

#include "demens/contact/friction.hpp"

namespace demens::contact {

//! Mindlin's no-slip stiffness S_t = 8 G* sqrt(R* d) in increments, dF_t = -S_t ds_t, with a Coulomb limit
//! and the damping 2 sqrt(5/6) beta sqrt(S_t m*) v_t while it sticks (Mindlin 1949; Tsuji et al. 1992). In
//! unloading the stored force shrinks with the contact radius, sqrt(d/d_old), so that an oblique impact
//! creates no energy (Thornton et al. 2013).
template <class Friction>
class MindlinRescaleTangentialWith : public LawTraits
{
  public:
    //! Sliding (0 or 1), overlap of the previous step [m], elastic force of the previous step [N].
    static constexpr int state_scalars = 2;
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;
    static constexpr bool has_dashpot = true;

    MindlinRescaleTangentialWith(PairMaterial const& material, PairProperties const& pair)
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
        double const old_overlap = history.scalars[1];
        bool const unloads = contact.overlap < old_overlap;
        double const larger = unloads ? old_overlap : contact.overlap;
        double const smaller = unloads ? contact.overlap : old_overlap;
        double const ratio = std::sqrt(smaller / (larger > 1e-300 ? larger : 1e-300)); // of contact radii
        double const shrink = unloads ? ratio : 1.0;
        // In loading the stiffness of the middle of the step, in unloading that to which the force has
        // shrunk.
        double const mean = unloads ? stiffness : 0.5 * stiffness * (1 + ratio);
        Vector3 const trial = shrink * turned_into_plane(history.vectors[0], contact.normal) -
                              (mean * contact.time_step) * contact.tangent_velocity;
        history.vectors[0] =
            friction_.in(contact).limit(norm(trial), normal.limit, history.scalars[0]) * trial;
        history.scalars[1] = contact.overlap;
        double const sticks = normal.limit > 0 ? 1 - history.scalars[0] : 0.0; // a pull holds nothing
        double const viscous = sticks * damping_ * contact.damping_scale;
        return {history.vectors[0], viscous * contact.tangent_velocity,
                spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double shear_modulus_; //!< G* [Pa]
    double damping_;       //!< 2 sqrt(5/6) beta sqrt(8 G*) [Pa^(1/2)]
    Friction friction_;
};

using MindlinRescaleTangential = MindlinRescaleTangentialWith<CoulombFriction>;

} // namespace demens::contact
