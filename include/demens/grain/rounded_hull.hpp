#pragma once

#include "demens/grain/hull.hpp"

namespace demens::grain {

//! A hull whose edges and corners are round: all places within `rounding` of a core.
struct RoundedHull
{
    Hull core;
    double rounding = 0; //!< [m]
};

//! A hull with its edges and corners rounded, its faces where they were: the core is what remains when each
//! face moves inwards by `rounding` [m] (what a ball of that radius reaches inside the hull; faces that no
//! ball reaches are gone). Corners of more than three faces stay one where the faces are then off by no more
//! than a quarter of the rounding: else each would become several near to each other. \throws InputError
//! where that is not less than the distance of the hull's centre from its nearest face; `origin` stands
//! before the message.
RoundedHull rounded(Hull const& hull, double rounding, std::string const& origin);

//! Exact but for rounding: core, prisms on faces, wedges along edges and sectors of balls at corners; the
//! volume is Steiner's V + S r + r^2 sum(length * outer angle) / 2 + 4/3 pi r^3.
VolumeMoments volume_moments(RoundedHull const& hull);
MassProperties mass_properties(RoundedHull const& hull);

//! The balls whose hull it is.
Clump corner_balls(RoundedHull const& hull);
RoundedHull scaled(RoundedHull const& hull, double factor);
//! Seen from its centre along its principal axes.
RoundedHull in_principal_axes(RoundedHull const& hull, MassProperties const& properties);

} // namespace demens::grain
