#pragma once

#include "demens/base/quaternion.hpp"
#include "demens/base/vector3.hpp"
#include "demens/dem/ids.hpp"
#include "demens/grain/body_shape.hpp"

#include <memory>
#include <vector>

namespace demens::dem {

//! A grain that enters a simulation, as it is at the present time: a sphere, or a rigid body of several
//! elements that move together, or a rounded hull, which is read as its balls.
struct Body
{
    Vector3 position; //!< of the centre of mass [m]
    double radius;    //!< of the sphere of the same volume [m]
    MaterialId material = {};
    Vector3 velocity = {};                              //!< [m/s]
    Vector3 spin = {};                                  //!< [rad/s]
    std::shared_ptr<grain::BodyShape const> shape = {}; //!< none: a sphere
    Quaternion orientation = {};                        //!< from the shape's axes to those of space

    //! Whether it moves as a sphere, without an orientation.
    bool is_sphere() const { return !shape || shape->is_sphere(); }
    bool is_hull() const { return shape && shape->is_hull(); }
    std::size_t elements() const { return shape ? shape->balls.size() : 1; }
};

using BodyBatch = std::vector<Body>;

} // namespace demens::dem
