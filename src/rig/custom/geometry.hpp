#pragma once

#include "demens/base/error.hpp"
#include "demens/base/options.hpp"

#include <numbers>
#include <string>

#include <fmt/format.h>

//! What keys say in units of their own, in SI units.
namespace demens::rig::custom {

constexpr double degree = std::numbers::pi / 180; //!< [rad]

inline Vector3 millimetres(OptionValues const& o, std::string const& key)
{
    return 1e-3 * o.vector(key);
}

//! A unit vector. \throws InputError
inline Vector3 direction(OptionValues const& o, std::string const& key)
{
    auto const& v = o.vector(key);
    if (!(norm(v) > 0))
        throw InputError(key + " = [0, 0, 0] is no direction");
    return v / norm(v);
}

//! A place, for messages.
inline std::string in_millimetres(Vector3 const& p)
{
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
}

} // namespace demens::rig::custom
