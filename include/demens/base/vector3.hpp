#pragma once

#include "demens/base/macros.hpp"

#include <cmath>

namespace demens {

//! Three Cartesian components.
struct Vector3
{
    double x = 0, y = 0, z = 0;

    DEMENS_FUNCTION constexpr Vector3& operator+=(Vector3 const& b)
    {
        x += b.x, y += b.y, z += b.z;
        return *this;
    }
    DEMENS_FUNCTION constexpr Vector3& operator-=(Vector3 const& b)
    {
        x -= b.x, y -= b.y, z -= b.z;
        return *this;
    }
    DEMENS_FUNCTION constexpr Vector3& operator*=(double s)
    {
        x *= s, y *= s, z *= s;
        return *this;
    }
    friend constexpr bool operator==(Vector3 const&, Vector3 const&) = default;
};

DEMENS_FUNCTION constexpr Vector3 operator+(Vector3 a, Vector3 const& b)
{
    return a += b;
}
DEMENS_FUNCTION constexpr Vector3 operator-(Vector3 a, Vector3 const& b)
{
    return a -= b;
}
DEMENS_FUNCTION constexpr Vector3 operator-(Vector3 const& a)
{
    return {-a.x, -a.y, -a.z};
}
DEMENS_FUNCTION constexpr Vector3 operator*(Vector3 a, double s)
{
    return a *= s;
}
DEMENS_FUNCTION constexpr Vector3 operator*(double s, Vector3 a)
{
    return a *= s;
}
DEMENS_FUNCTION constexpr Vector3 operator/(Vector3 a, double s)
{
    return a *= 1.0 / s;
}

DEMENS_FUNCTION constexpr double dot(Vector3 const& a, Vector3 const& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
DEMENS_FUNCTION constexpr Vector3 cross(Vector3 const& a, Vector3 const& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
DEMENS_FUNCTION constexpr double norm_squared(Vector3 const& a)
{
    return dot(a, a);
}
DEMENS_FUNCTION inline double norm(Vector3 const& a)
{
    return std::sqrt(norm_squared(a));
}
//! A unit vector at a right angle to a unit vector.
DEMENS_FUNCTION inline Vector3 any_normal_to(Vector3 const& axis)
{
    Vector3 const other = axis.x * axis.x < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    Vector3 const across = other - dot(other, axis) * axis;
    return across / norm(across);
}

} // namespace demens
