#pragma once

#include "demens/base/contract.hpp"
#include "demens/contact/evaluation/meeting.hpp"
#include "demens/contact/kinematics.hpp"

namespace demens::contact {

//! What follows from a meeting, whatever the laws.
struct ContactGeometry
{
    Vector3 normal;           //!< unit vector from j to i
    double overlap, gap;      //!< of the surfaces; one of them is 0 [m]
    double arm_i, arm_j;      //!< from the centres to the contact point [m]
    double effective_radius;  //!< R* [m]
    double contact_radius;    //!< sqrt(R* overlap) [m]
    double effective_mass;    //!< m* [kg]
    double damping_scale;     //!< sqrt(m* sqrt(R* overlap)) [kg^(1/2) m^(1/2)]
    double normal_velocity;   //!< of the surfaces, positive when separating [m/s]
    Vector3 tangent_velocity; //!< of i relative to j at the contact point [m/s]
};

//! Geometry of a contact, and how the two surfaces move past each other.
template <Partner partner>
DEMENS_INLINE DEMENS_FUNCTION ContactGeometry geometry_of(Meeting const& m)
{
    constexpr bool wall = partner == Partner::wall;
    DEMENS_EXPECT(m.radius_i > 0 && m.radius_j > 0 && m.mass_i > 0 && m.mass_j > 0, "bodies have a size");
    // A wall is flat and cannot be moved: it adds neither curvature nor mass, and its point of contact is its
    // own.
    constexpr double share_of_j = wall ? 0.0 : 1.0;
    double const distance = norm(m.apart);
    double const inverse = 1 / distance;
    Vector3 const normal = inverse * m.apart;
    double const ri = m.radius_i, rj = m.radius_j;
    double const depth = ri + share_of_j * rj - distance;
    double const overlap = depth > 0 ? depth : 0.0;
    // Two spheres share the overlap, which keeps angular momentum; on a wall the arm is the radius, as in
    // the closed forms of rolling and oblique impact.
    double const arm_i = wall ? ri : ri - 0.5 * overlap;
    double const arm_j = share_of_j * (rj - 0.5 * overlap);
    // Relative velocity of the two surfaces at the contact point.
    Vector3 const velocity = m.velocity - cross(arm_i * m.spin_i + arm_j * m.spin_j, normal);
    double const normal_velocity = dot(velocity, normal);
    double const mi = m.mass_i, mj = m.mass_j;
    double const radius_sum = ri + rj, mass_sum = mi + mj;
    double const per_sums = 1 / (radius_sum * mass_sum); // one division for both
    double const radius = wall ? ri : ri * rj * mass_sum * per_sums;
    double const mass = wall ? mi : mi * mj * radius_sum * per_sums;
    double const contact_radius = std::sqrt(radius * overlap);
    return {.normal = normal,
            .overlap = overlap,
            .gap = overlap - depth,
            .arm_i = arm_i,
            .arm_j = arm_j,
            .effective_radius = radius,
            .contact_radius = contact_radius,
            .effective_mass = mass,
            .damping_scale = std::sqrt(mass * contact_radius),
            .normal_velocity = normal_velocity,
            .tangent_velocity = velocity - normal_velocity * normal};
}

//! By how much an overlap is more than a share of the smaller radius [m].
DEMENS_INLINE DEMENS_FUNCTION double overlap_excess(Meeting const& m, double overlap, double largest_share)
{
    return overlap - largest_share * (m.radius_i < m.radius_j ? m.radius_i : m.radius_j);
}

//! Moment of inertia of two bodies that roll on each other, about the contact point [kg m^2].
DEMENS_INLINE DEMENS_FUNCTION double rolling_inertia(Meeting const& m)
{
    double const i = 1.4 * m.mass_i * m.radius_i * m.radius_i;
    double const j = 1.4 * m.mass_j * m.radius_j * m.radius_j;
    return i / (1 + i / j); // a wall's mass is beyond any other
}

//! What the laws read.
DEMENS_INLINE DEMENS_FUNCTION ContactKinematics kinematics_of(Meeting const& m, ContactGeometry const& g,
                                                              double time_step)
{
    return {.normal = g.normal,
            .overlap = g.overlap,
            .gap = g.gap,
            .radius_i = m.radius_i,
            .radius_j = m.radius_j,
            .effective_radius = g.effective_radius,
            .contact_radius = g.contact_radius,
            .effective_mass = g.effective_mass,
            .damping_scale = g.damping_scale,
            .rolling_inertia = rolling_inertia(m),
            .normal_velocity = g.normal_velocity,
            .tangent_velocity = g.tangent_velocity,
            .relative_spin = m.spin_i - m.spin_j,
            .time_step = time_step};
}

} // namespace demens::contact
