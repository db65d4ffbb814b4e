#pragma once

#include "demens/base/quaternion.hpp"
#include "demens/grain/body_shape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace demens::rig::custom {

//! A grain as it enters a simulation.
struct Body
{
    Vector3 place;                                      //!< [m]
    double radius = 0;                                  //!< of the sphere of the same volume [m]
    Vector3 velocity = {};                              //!< [m/s]
    Vector3 spin = {};                                  //!< [rad/s]
    std::string origin = {};                            //!< where it was given, for messages
    std::shared_ptr<grain::BodyShape const> shape = {}; //!< none: a sphere
    Quaternion orientation = {};                        //!< from the shape's own axes to those of space

    double reach() const { return shape ? radius * shape->reach() : radius; } //!< from its centre [m]
};

//! The grains of a table, and its columns that say nothing of them.
struct ParticleTable
{
    std::vector<Body> bodies;
    std::vector<std::string> unused = {};
    bool has_orientations = false; //!< columns that say how grains stand, over their shape as given
};

//! Grains from text with the header `x,y,z,radius`, and beside these, all of them or none, the columns vx,
//! vy, vz, the spins wx, wy, wz and the quaternions qw, qx, qy, qz; in any order, in SI units. Columns of
//! names and numbers of the particles may stand beside them. \throws InputError with file, line and column
ParticleTable read_particle_csv(std::string const& text, std::string const& file);

} // namespace demens::rig::custom
