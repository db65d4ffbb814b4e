#include "demens/grain/mass_properties.hpp"

#include "demens/base/contract.hpp"
#include "src/grain/eigen_system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::grain {
namespace {

//! Moments that differ by less than this part of the largest are equal: rounding would choose their axes.
constexpr double equal_moments = 1e-9;

//! Towards the side on which the first component that is not small is positive.
Vector3 on_one_side(Vector3 const& v)
{
    double const enough = 0.5 * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    double const first = std::abs(v.x) > enough ? v.x : std::abs(v.y) > enough ? v.y : v.z;
    return first < 0 ? -v : v;
}

//! Fixes what the eigenvectors leave open.
void settle(EigenSystem& system)
{
    auto& [low, middle, high] = system.values;
    auto& vectors = system.vectors;
    double const little = equal_moments * high;
    if (high - low < little) {
        low = middle = high = (low + middle + high) / 3;
        vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        return;
    }
    if (middle - low < little) {
        low = middle = 0.5 * (low + middle);
        vectors[0] = any_normal_to(vectors[2]);
        vectors[1] = cross(vectors[2], vectors[0]);
    } else if (high - middle < little) {
        middle = high = 0.5 * (middle + high);
        vectors[1] = any_normal_to(vectors[0]);
    }
    vectors[0] = on_one_side(vectors[0]);
    vectors[1] = on_one_side(vectors[1]);
    vectors[2] = cross(vectors[0], vectors[1]);
}

} // namespace

SymmetricTensor& SymmetricTensor::operator+=(SymmetricTensor const& b)
{
    xx += b.xx, yy += b.yy, zz += b.zz, xy += b.xy, xz += b.xz, yz += b.yz;
    return *this;
}

SymmetricTensor operator+(SymmetricTensor a, SymmetricTensor const& b)
{
    return a += b;
}

SymmetricTensor operator*(double s, SymmetricTensor const& a)
{
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}

Vector3 operator*(SymmetricTensor const& a, Vector3 const& v)
{
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
}

double frobenius(SymmetricTensor const& a)
{
    return std::sqrt(a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz));
}

SymmetricTensor products(Vector3 const& v)
{
    return products(v, v);
}

SymmetricTensor products(Vector3 const& a, Vector3 const& b)
{
    return {a.x * b.x,
            a.y * b.y,
            a.z * b.z,
            0.5 * (a.x * b.y + a.y * b.x),
            0.5 * (a.x * b.z + a.z * b.x),
            0.5 * (a.y * b.z + a.z * b.y)};
}

VolumeMoments& VolumeMoments::operator+=(VolumeMoments const& b)
{
    volume += b.volume;
    first += b.first;
    second += b.second;
    return *this;
}

VolumeMoments VolumeMoments::shifted(Vector3 const& shift) const
{
    return {volume, first + volume * shift, second + 2 * products(first, shift) + volume * products(shift)};
}

MassProperties MassProperties::scaled(double factor) const
{
    double const volume_factor = factor * factor * factor, inertia_factor = volume_factor * factor * factor;
    return {volume_factor * volume, factor * centre, inertia_factor * inertia, inertia_factor * moments,
            axes};
}

double MassProperties::equivalent_diameter() const
{
    return std::cbrt(6 * volume / std::numbers::pi);
}

MassProperties mass_properties_of(VolumeMoments const& moments)
{
    DEMENS_EXPECT(moments.volume > 0, "a solid has a volume");
    Vector3 const centre = moments.first / moments.volume;
    SymmetricTensor const about = moments.second + -moments.volume * products(centre);
    SymmetricTensor const inertia{about.yy + about.zz, about.xx + about.zz, about.xx + about.yy,
                                  -about.xy,           -about.xz,           -about.yz};
    EigenSystem system = eigen_system(inertia);
    settle(system);
    return {moments.volume,
            centre,
            inertia,
            {system.values[0], system.values[1], system.values[2]},
            quaternion_of({system.vectors[0], system.vectors[1], system.vectors[2]})};
}

} // namespace demens::grain
