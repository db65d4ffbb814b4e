#pragma once

#include "demens/base/contract.hpp"
#include "demens/base/macros.hpp"
#include "demens/base/vector3.hpp"

namespace demens::contact {

//! Geometry and relative motion of one contact of bodies i and j; a wall takes the place of j.
struct ContactKinematics
{
    Vector3 normal;  //!< unit vector from j to i
    double overlap;  //!< [m], 0 where a force acts across a gap
    double gap;      //!< distance of the surfaces [m], 0 in contact
    double radius_i; //!< [m]
    double radius_j; //!< [m]; against a wall the radius of i, as its stiffness is that of a like sphere
    double effective_radius;  //!< R* [m]; against a wall the radius of i
    double contact_radius;    //!< sqrt(R* overlap), of Hertz's contact [m]
    double effective_mass;    //!< m* [kg]; against a wall the mass of i
    double damping_scale;     //!< sqrt(m* sqrt(R* overlap)), what all damping of Hertzian contacts is
                              //!< proportional to [kg^(1/2) m^(1/2)]
    double rolling_inertia;   //!< equivalent moment of inertia about the contact point [kg m^2]
    double normal_velocity;   //!< [m/s], positive when separating
    Vector3 tangent_velocity; //!< of i relative to j at the contact point, in the contact plane [m/s]
    Vector3 relative_spin;    //!< angular velocity of i minus that of j [rad/s]
    double time_step;         //!< [s]
};

//! What a normal law tells the laws that come after it.
struct NormalResponse
{
    double force = 0;     //!< along the normal on i [N], positive when repulsive
    double limit = 0;     //!< force that limits friction and rolling [N], never negative
    double stiffness = 0; //!< tangent (Hertz) or loading (spring) stiffness [N/m]
    double inelastic = 0; //!< part of the force that is not the slope of `stored` [N]
    double stored = 0;    //!< energy that unloading gives back [J]
};

//! What a cohesion law gives.
struct CohesionResponse
{
    double force;  //!< along the normal on i [N], never positive unless the law may push
    double stored; //!< its potential, 0 beyond its range [J], of the sign of the force
    double lost;   //!< energy lost in this step because a bond has formed or broken [J]
};

//! What a tangential law (force on i) or a rolling law (torque on i) gives, in two parts.
struct Resistance
{
    Vector3 spring;    //!< limited by friction [N] or [N m]
    Vector3 viscous{}; //!< [N] or [N m]
    double stored = 0; //!< energy in the spring [J]
};

//! Turns a stored vector into the plane normal to n and keeps its length.
DEMENS_INLINE DEMENS_FUNCTION Vector3 turned_into_plane(Vector3 const& stored, Vector3 const& n)
{
    Vector3 const in_plane = stored - dot(stored, n) * n;
    double const before = norm_squared(stored);
    double const after = norm_squared(in_plane);
    // A vector along the normal has no direction in the plane: it is dropped.
    double const scale = std::sqrt(after > 1e-30 * before ? before / after : 0.0);
    return scale * in_plane;
}

//! Factor in [0, 1] that brings a vector of length `size` to at most `limit`.
DEMENS_INLINE DEMENS_FUNCTION double share_within(double size, double limit)
{
    double const larger = size > limit ? size : limit;
    DEMENS_EXPECT(!(limit < 0), "a limit of a force or torque");
    return limit / (larger > 1e-300 ? larger : 1e-300);
}

//! Energy of a spring under a load, F^2/(2 k); an unloaded one may have no stiffness.
DEMENS_INLINE DEMENS_FUNCTION double spring_energy(double load_squared, double stiffness)
{
    return 0.5 * load_squared / (stiffness > 1e-300 ? stiffness : 1e-300);
}

//! Static and kinetic friction with a state: a contact that slides resists with the kinetic coefficient and
//! sticks again once the trial force is below that limit (Moncada et al. 2023, eq. 3, with two coefficients).
struct CoulombFriction
{
    double static_coefficient, kinetic_coefficient;

    //! What limits friction in this contact.
    DEMENS_INLINE DEMENS_FUNCTION CoulombFriction const& in(ContactKinematics const&) const { return *this; }

    //! Factor in [0, 1] that brings a trial force of magnitude `trial` [N] to its limit; updates the state
    //! `sliding` (0 sticks, 1 slides).
    DEMENS_INLINE DEMENS_FUNCTION double limit(double trial, double normal_force, double& sliding) const
    {
        DEMENS_EXPECT(!(normal_force < 0), "what limits friction pushes");
        double const threshold = (sliding > 0.5 ? kinetic_coefficient : static_coefficient) * normal_force;
        double const size = trial > 1e-300 ? trial : 1e-300;
        bool const slides = trial > threshold;
        sliding = slides && normal_force > 0 ? 1.0 : 0.0; // across a gap nothing slides
        return (slides ? kinetic_coefficient * normal_force : size) / size;
    }
};

//! Kinetic friction that weakens with the slip speed v: mu_k (1 - w v/(v + v_w)), down to 1 - w of it (the
//! form of rate-weakening laws, e.g. Rice 2006; here without a state of its own).
struct WeakeningFriction
{
    double static_coefficient, kinetic_coefficient;
    double share, speed; //!< w, v_w [m/s]

    //! What limits friction in this contact.
    DEMENS_INLINE DEMENS_FUNCTION CoulombFriction in(ContactKinematics const& contact) const
    {
        double const slip = norm(contact.tangent_velocity);
        return {static_coefficient, kinetic_coefficient * (1 - share * slip / (slip + speed))};
    }
};

} // namespace demens::contact
