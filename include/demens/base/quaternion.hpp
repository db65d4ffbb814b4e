#pragma once

#include "demens/base/rotation.hpp"

namespace demens {

//! An orientation as a unit quaternion w + xi + yj + zk.
struct Quaternion
{
    double w = 1, x = 0, y = 0, z = 0;

    //! The turn back.
    DEMENS_FUNCTION constexpr Quaternion conjugate() const { return {w, -x, -y, -z}; }
    //! First `b`, then this.
    DEMENS_FUNCTION constexpr Quaternion operator*(Quaternion const& b) const
    {
        return {w * b.w - x * b.x - y * b.y - z * b.z, w * b.x + x * b.w + y * b.z - z * b.y,
                w * b.y - x * b.z + y * b.w + z * b.x, w * b.z + x * b.y - y * b.x + z * b.w};
    }
    //! The same of unit length; once a step it keeps rounding from growing.
    DEMENS_FUNCTION Quaternion normalized() const
    {
        double const scale = 1 / std::sqrt(w * w + x * x + y * y + z * z);
        return {w * scale, x * scale, y * scale, z * scale};
    }
    //! The images of the three axes.
    DEMENS_FUNCTION constexpr Rotation rotation() const
    {
        double const xx = 2 * x * x, yy = 2 * y * y, zz = 2 * z * z;
        double const xy = 2 * x * y, xz = 2 * x * z, yz = 2 * y * z;
        double const wx = 2 * w * x, wy = 2 * w * y, wz = 2 * w * z;
        return {{1 - (yy + zz), xy + wz, xz - wy},
                {xy - wz, 1 - (xx + zz), yz + wx},
                {xz + wy, yz - wx, 1 - (xx + yy)}};
    }
    //! Image of a vector.
    DEMENS_FUNCTION constexpr Vector3 operator()(Vector3 const& v) const
    {
        Vector3 const u{x, y, z}, t = 2.0 * cross(u, v);
        return v + w * t + cross(u, t);
    }
    //! Image of a vector under the turn back.
    DEMENS_FUNCTION constexpr Vector3 inverse(Vector3 const& v) const { return conjugate()(v); }

    friend constexpr bool operator==(Quaternion const&, Quaternion const&) = default;
};

//! Turn about a vector by its length [rad], counter-clockwise seen against it.
DEMENS_FUNCTION inline Quaternion quaternion_about(Vector3 const& turn)
{
    double const angle = norm(turn), half = 0.5 * angle;
    // sin(angle / 2) / angle; its series where the angle is too small to divide by.
    double const s = angle > 1e-4 ? std::sin(half) / angle : 0.5 - angle * angle / 48;
    return {std::cos(half), s * turn.x, s * turn.y, s * turn.z};
}

//! The quaternion of a rotation, with w >= 0 (Shepperd 1978).
DEMENS_FUNCTION inline Quaternion quaternion_of(Rotation const& r)
{
    double const trace = r.x.x + r.y.y + r.z.z;
    Quaternion q;
    if (trace >= r.x.x && trace >= r.y.y && trace >= r.z.z)
        q = {1 + trace, r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};
    else if (r.x.x >= r.y.y && r.x.x >= r.z.z)
        q = {r.y.z - r.z.y, 1 + r.x.x - r.y.y - r.z.z, r.x.y + r.y.x, r.z.x + r.x.z};
    else if (r.y.y >= r.z.z)
        q = {r.z.x - r.x.z, r.x.y + r.y.x, 1 + r.y.y - r.x.x - r.z.z, r.y.z + r.z.y};
    else
        q = {r.x.y - r.y.x, r.z.x + r.x.z, r.y.z + r.z.y, 1 + r.z.z - r.x.x - r.y.y};
    q = q.normalized();
    return q.w < 0 ? Quaternion{-q.w, -q.x, -q.y, -q.z} : q;
}

} // namespace demens
