#pragma once

#include <limits>
#include <string>

namespace demens::ensemble::input {

// What lists of options have in common.

inline constexpr double positive = std::numeric_limits<double>::min(); //!< least number greater than 0
inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
inline std::string const word; //!< default of a word that may be left out

} // namespace demens::ensemble::input
