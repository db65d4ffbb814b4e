#pragma once

#include "demens/base/vector3.hpp"

#include <string>
#include <vector>

namespace demens::rig::custom {

//! A sphere as it enters a simulation.
struct Body
{
    Vector3 place;           //!< [m]
    double radius = 0;       //!< [m]
    Vector3 velocity = {};   //!< [m/s]
    Vector3 spin = {};       //!< [rad/s]
    std::string origin = {}; //!< where it was given, for messages
};

//! Spheres from text with the header `x,y,z,radius` or `x,y,z,radius,vx,vy,vz`, columns in any order, in SI
//! units. Blank lines and lines that begin with # are left out. \throws InputError with file, line and column
std::vector<Body> read_particle_csv(std::string const& text, std::string const& file);

} // namespace demens::rig::custom
