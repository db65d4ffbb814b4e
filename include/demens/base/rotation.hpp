#pragma once

#include "demens/base/vector3.hpp"

namespace demens {

//! A turn in space, by the images of the three axes.
struct Rotation
{
    Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    DEMENS_FUNCTION constexpr Vector3 operator()(Vector3 const& v) const
    {
        return v.x * x + v.y * y + v.z * z;
    }
    //! The turn back.
    DEMENS_FUNCTION constexpr Vector3 inverse(Vector3 const& v) const
    {
        return {dot(x, v), dot(y, v), dot(z, v)};
    }
    //! First `b`, then this.
    DEMENS_FUNCTION constexpr Rotation operator*(Rotation const& b) const
    {
        return {(*this)(b.x), (*this)(b.y), (*this)(b.z)};
    }
};

//! Turn by an angle [rad] about a unit vector, counter-clockwise seen against it (Rodrigues).
inline Rotation rotation_about(Vector3 const& axis, double angle)
{
    double const c = std::cos(angle), s = std::sin(angle);
    auto const image = [&](Vector3 const& e) {
        return c * e + s * cross(axis, e) + (1 - c) * dot(axis, e) * axis;
    };
    return {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1})};
}

//! Where a rigid body has been put: first turned about the origin, then shifted.
struct Placement
{
    Rotation rotation;
    Vector3 shift; //!< [m]

    DEMENS_FUNCTION constexpr Vector3 operator()(Vector3 const& p) const { return rotation(p) + shift; }
    DEMENS_FUNCTION constexpr Vector3 inverse(Vector3 const& p) const { return rotation.inverse(p - shift); }
    //! First `b`, then this.
    DEMENS_FUNCTION constexpr Placement operator*(Placement const& b) const
    {
        return {rotation * b.rotation, (*this)(b.shift)};
    }
};

//! Turn by an angle [rad] about the line through a point along a unit vector.
inline Placement turn_about(Vector3 const& point, Vector3 const& axis, double angle)
{
    Rotation const rotation = rotation_about(axis, angle);
    return {rotation, point - rotation(point)};
}

} // namespace demens
