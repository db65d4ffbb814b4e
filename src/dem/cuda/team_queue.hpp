#pragma once

#include "src/dem/cuda/team.hpp"

namespace demens::dem::cuda {

//! Work that waits for one of the lanes of a team, whoever is free: a contact of the particle of a lane.
struct QueuedContact
{
    std::uint32_t bits;

    DEMENS_FUNCTION static QueuedContact of(std::uint32_t lane, std::uint32_t entry, bool is_new)
    {
        return {lane << 8 | entry << 1 | static_cast<std::uint32_t>(is_new)};
    }
    DEMENS_FUNCTION std::uint32_t lane() const { return bits >> 8; }
    DEMENS_FUNCTION std::uint32_t entry() const { return bits >> 1 & 31; } //!< of the lane's word of its list
    DEMENS_FUNCTION bool is_new() const { return bits & 1; }
};

//! What the lanes of a team share: contacts, and then the loads that they make.
struct TeamQueue
{
    //! Dense beds have 3.5 to 4 contacts a particle; what is more than that waits for the next round.
    static constexpr std::uint32_t room = 4 * team_size;

    QueuedContact contact[room];
    double load[6][room]; //!< force [N], torque [N m]

    DEMENS_FUNCTION Load load_of(std::uint32_t k) const
    {
        return {load[0][k], load[1][k], load[2][k], 0, load[3][k], load[4][k], load[5][k], 0};
    }
    DEMENS_FUNCTION void keep(std::uint32_t k, Load const& l)
    {
        load[0][k] = l.fx, load[1][k] = l.fy, load[2][k] = l.fz;
        load[3][k] = l.tx, load[4][k] = l.ty, load[5][k] = l.tz;
    }
};

} // namespace demens::dem::cuda
