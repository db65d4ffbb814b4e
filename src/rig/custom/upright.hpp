#pragma once

#include "demens/base/vector3.hpp"

namespace demens::rig::custom {

//! Coordinates that stand upright: z against gravity, where there is none along z. x and y are horizontal.
//! With gravity along an axis they are the axes, without rounding.
class Upright
{
  public:
    explicit Upright(Vector3 const& gravity);
    //! x as far along a direction as is horizontal; see `is_horizontal`.
    Upright(Vector3 const& gravity, Vector3 const& along);

    //! Whether a direction has a part that is horizontal.
    static bool has_horizontal_part(Vector3 const& gravity, Vector3 const& direction);

    double height(Vector3 const& p) const { return dot(p, z_); }
    Vector3 upright(Vector3 const& p) const { return {dot(p, x_), dot(p, y_), dot(p, z_)}; }
    Vector3 back(Vector3 const& p) const { return p.x * x_ + p.y * y_ + p.z * z_; }

  private:
    Vector3 x_, y_, z_; //!< unit vectors
};

} // namespace demens::rig::custom
