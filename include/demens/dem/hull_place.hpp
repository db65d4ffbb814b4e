#pragma once

#include "demens/base/quaternion.hpp"
#include "demens/dem/ids.hpp"
#include "demens/grain/body_shape.hpp"

#include <memory>

namespace demens::dem {

//! A grain that is a rounded hull, where it is.
struct HullPlace
{
    ParticleId id;    //!< the first of those that it is read with
    Vector3 position; //!< of the centre of mass [m]
    Quaternion orientation;
    double radius; //!< of the sphere of the same volume, by which its shape grows [m]
    std::shared_ptr<grain::BodyShape const> shape;

    //! Where a place of the shape is [m].
    Vector3 operator()(Vector3 const& of_shape) const { return position + orientation(radius * of_shape); }
    double rounding() const { return radius * shape->hull->rounding; } //!< [m]
};

} // namespace demens::dem
