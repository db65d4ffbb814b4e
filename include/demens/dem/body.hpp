#pragma once

#include "demens/base/vector3.hpp"
#include "demens/dem/ids.hpp"

#include <vector>

namespace demens::dem {

//! A sphere that enters a simulation, as it is at the present time.
struct Body
{
    Vector3 position; //!< [m]
    double radius;    //!< [m]
    MaterialId material = {};
    Vector3 velocity = {}; //!< [m/s]
    Vector3 spin = {};     //!< [rad/s]
};

using BodyBatch = std::vector<Body>;

} // namespace demens::dem
