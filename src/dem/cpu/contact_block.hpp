#pragma once

#include "demens/contact/evaluation/geometry.hpp"

#include <cstdint>

namespace demens::dem {

//! Contacts of one kind gathered side by side, so that each law is a loop over lanes that vectorises. Lanes
//! past `count` repeat the last contact and are not scattered.
struct alignas(64) ContactBlock
{
    static constexpr int lanes = 32;
    static constexpr int max_state = 28;
    using Lane = double[lanes];

    //! Lanes that are computed for so many contacts: whole registers.
    static constexpr int padded(int contacts) { return (contacts + 7) / 8 * 8; }

    int count = 0;
    std::uint32_t slot[lanes]; //!< place in the contact list

    // Gathered
    Lane dx, dy, dz;         //!< from j (wall: nearest point) to i [m]
    Lane radius_i, radius_j; //!< wall: both the radius of i [m]
    Lane mass_i, mass_j;     //!< wall: mass_j is infinite [kg]
    Lane vx, vy, vz;         //!< velocity of i minus that of j [m/s]
    Lane wix, wiy, wiz;      //!< spin of i [rad/s]
    Lane wjx, wjy, wjz;      //!< spin of j, also of a wall [rad/s]
    Lane state[max_state];   //!< history

    // Derived
    Lane nx, ny, nz, overlap, gap, arm_i, arm_j;
    Lane effective_radius, contact_radius, effective_mass, damping_scale;
    Lane normal_velocity, tx, ty, tz; //!< tangent velocity
    Lane limit, stiffness;            //!< of the normal law

    // Results
    Lane fx, fy, fz; //!< force on i, at the contact point [N]
    Lane mx, my, mz; //!< rolling torque on i [N m]

    // Results for the energy ledger: lost since the step before [J]
    Lane lost_to_damping, lost_to_friction, lost_to_rolling, lost_to_cohesion;
};

//! Fills the derived quantities; bodies apart have a gap and no overlap. Returns whether any overlap is more
//! than `overlap_limit` times the smaller radius of the two bodies.
bool derive_geometry(ContactBlock& block, bool with_wall, double overlap_limit);

//! The bodies of lane l.
DEMENS_INLINE contact::Meeting meeting_of(ContactBlock const& b, int l)
{
    return {.apart = {b.dx[l], b.dy[l], b.dz[l]},
            .radius_i = b.radius_i[l],
            .radius_j = b.radius_j[l],
            .mass_i = b.mass_i[l],
            .mass_j = b.mass_j[l],
            .velocity = {b.vx[l], b.vy[l], b.vz[l]},
            .spin_i = {b.wix[l], b.wiy[l], b.wiz[l]},
            .spin_j = {b.wjx[l], b.wjy[l], b.wjz[l]}};
}

} // namespace demens::dem
