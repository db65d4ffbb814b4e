#pragma once

#include "demens/base/bytes.hpp"

#include <cstdint>

namespace demens::test {

//! Bytes some of which are changed. \param data four bytes for each change: its place in three, the new one
inline Bytes changed_bytes(Bytes bytes, std::uint8_t const* data, std::size_t size)
{
    for (std::size_t i = 0; i + 4 <= size; i += 4) {
        auto const place = data[i] | data[i + 1] << 8 | data[i + 2] << 16;
        bytes[static_cast<std::size_t>(place) % bytes.size()] = static_cast<std::byte>(data[i + 3]);
    }
    return bytes;
}

} // namespace demens::test
