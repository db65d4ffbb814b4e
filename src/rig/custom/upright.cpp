#include "src/rig/custom/upright.hpp"

#include <cmath>

namespace demens::rig::custom {
namespace {

//! A vector of length 1; along an axis exactly.
Vector3 unit(Vector3 const& v)
{
    auto const sign = [](double a) { return a > 0 ? 1.0 : a < 0 ? -1.0 : 0.0; };
    bool const along_axis = (v.x != 0) + (v.y != 0) + (v.z != 0) == 1;
    return along_axis ? Vector3{sign(v.x), sign(v.y), sign(v.z)} : v / norm(v);
}

Vector3 up_against(Vector3 const& gravity)
{
    return norm(gravity) > 0 ? unit(-gravity) : Vector3{0, 0, 1};
}

Vector3 horizontal_part(Vector3 const& direction, Vector3 const& up)
{
    return direction - dot(direction, up) * up;
}

} // namespace

Upright::Upright(Vector3 const& gravity)
    : Upright(gravity, std::abs(up_against(gravity).x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0})
{
}

Upright::Upright(Vector3 const& gravity, Vector3 const& along) : z_(up_against(gravity))
{
    x_ = unit(horizontal_part(along, z_));
    y_ = cross(z_, x_);
}

bool Upright::has_horizontal_part(Vector3 const& gravity, Vector3 const& direction)
{
    return norm(horizontal_part(direction, up_against(gravity))) > 1e-6;
}

} // namespace demens::rig::custom
