#pragma once

#include "demens/base/error.hpp"
#include "demens/base/file_error.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace demens::test {

//! The bytes of a case as text.
inline std::string text_of(std::uint8_t const* data, std::size_t size)
{
    return {reinterpret_cast<char const*>(data), size};
}

//! Calls a reader, which may refuse what it is given. Anything else that leaves it is a fault.
template <class Reader>
void read_or_refuse(Reader const& reader)
{
    try {
        reader();
    } catch (InputError const&) {
    } catch (FileError const&) {
    }
}

} // namespace demens::test
