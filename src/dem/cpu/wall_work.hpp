#pragma once

#include "demens/base/vector3.hpp"
#include "src/dem/cpu/contact_block.hpp"

namespace demens::dem {

//! Work in a step of walls that turn, beside that of their force and torque [J]. The surface moves as it does
//! where it is touched, but the torque is that of forces a radius from the centre, which keeps angular
//! momentum: an overlap further on. \param spin_of the wall's in a lane
template <class SpinOf>
double work_beside_torque(ContactBlock const& b, double time_step, SpinOf const& spin_of)
{
    double power = 0;
    for (int l = 0; l < b.count; ++l) {
        Vector3 const n{b.nx[l], b.ny[l], b.nz[l]}, force{b.fx[l], b.fy[l], b.fz[l]};
        power += (b.overlap[l] - b.gap[l]) * dot(spin_of(l), cross(n, force));
    }
    return power * time_step;
}

} // namespace demens::dem
