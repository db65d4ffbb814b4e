#pragma once

#include "demens/contact/rolling/epsd.hpp"

namespace demens::contact {

//! Elastic-plastic spring with the stiffness of the tangential contact, k_r = S_t R*^2, S_t = 8 G* sqrt(R*
//! d), and no dashpot; the limit is that of `epsd` (Iwashita and Oda 1998; Wensrich and Katterfeld 2012).
class Epsd2Rolling : public LawTraits
{
  public:
    //! Spring torque of the previous step [N m].
    static constexpr int state_vectors = 1;
    static constexpr bool history_is_load = true;

    Epsd2Rolling(PairMaterial const& material, PairProperties const& pair)
        : coefficient_(pair.rolling_friction), shear_modulus_(material.effective_shear_modulus)
    {
    }

    DEMENS_INLINE DEMENS_FUNCTION Resistance operator()(ContactKinematics const& contact,
                                                        NormalResponse const& normal,
                                                        History const& history) const
    {
        double const radius = contact.effective_radius;
        double const stiffness = 8 * shear_modulus_ * contact.contact_radius * radius * radius;
        Vector3 const trial = turned_into_plane(history.vectors[0], contact.normal) -
                              (stiffness * contact.time_step) * rolling_spin(contact);
        history.vectors[0] = share_within(norm(trial), coefficient_ * radius * normal.limit) * trial;
        return {history.vectors[0], {}, spring_energy(norm_squared(history.vectors[0]), stiffness)};
    }

  private:
    double coefficient_;   //!< mu_r
    double shear_modulus_; //!< G* [Pa]
};

} // namespace demens::contact
