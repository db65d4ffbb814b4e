#pragma once

#include <fmt/format.h>

#include <string>

namespace demens::gap {

//! 0.25 as "25 %".
inline std::string percent(double share)
{
    return fmt::format("{:.0f} %", 100 * share);
}

} // namespace demens::gap
