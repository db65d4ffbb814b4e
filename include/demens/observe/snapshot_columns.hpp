#pragma once

#include "demens/observe/snapshot.hpp"

namespace demens::observe {

//! The columns of a snapshot, or of a const one, that have a number for each particle.
template <class AnySnapshot>
auto columns_of(AnySnapshot& s)
{
    return std::array{&s.x, &s.y, &s.z, &s.radius, &s.vx, &s.vy, &s.vz, &s.wx, &s.wy, &s.wz};
}

} // namespace demens::observe
