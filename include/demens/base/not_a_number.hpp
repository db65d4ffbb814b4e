#pragma once

#include <limits>

namespace demens {

//! In the place of a number that there is not, or that is not known.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace demens
