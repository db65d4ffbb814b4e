#pragma once

#include "demens/base/macros.hpp"

#include <compare>
#include <cstdint>

namespace demens {

//! Number of one thing among its kind, in the order of adding; numbers of other kinds do not fit in its
//! place.
template <class Tag>
struct Id
{
    std::uint32_t value = 0;

    constexpr Id() = default;
    DEMENS_FUNCTION constexpr explicit Id(std::uint32_t number) : value(number) {}
    friend constexpr auto operator<=>(Id const&, Id const&) = default;
};

} // namespace demens
