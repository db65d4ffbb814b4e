#pragma once

#include "demens/contact/laws.hpp"
#include "demens/dem/contact_list.hpp"

namespace demens::dem {

//! Contacts of one kind gathered side by side, so that each law is a loop over lanes that vectorises. Lanes
//! past `count` repeat the last contact and are not scattered.
struct alignas(64) ContactBlock
{
    static constexpr int lanes = 32;
    static constexpr int max_state = 12;
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
    Lane wjx, wjy, wjz;      //!< spin of j [rad/s]
    Lane state[max_state];   //!< history

    // Derived
    Lane nx, ny, nz, overlap, arm_i, arm_j;
    Lane effective_radius, effective_mass, rolling_inertia;
    Lane normal_velocity, tx, ty, tz; //!< tangent velocity
    Lane normal_force, limit, stiffness;

    // Results
    Lane fx, fy, fz;                   //!< force on i [N]
    Lane mx, my, mz;                   //!< rolling torque on i [N m]
    Lane tix, tiy, tiz, tjx, tjy, tjz; //!< torques on i and j [N m]
};

//! Doubles of history per contact that a law set needs, in whole fours, and how many of them are scalars.
struct StateLayout
{
    int scalars, size;
};
StateLayout state_layout(contact::LawSet const& laws);

//! Fills the derived quantities. Returns the largest overlap over the smaller radius of the two bodies.
double derive_geometry(ContactBlock& block, bool with_wall);
//! Evaluates the laws: forces, torques and the new history of all lanes.
void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, double time_step);

} // namespace demens::dem
