#pragma once

#include "demens/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace demens::observe::frame_file {

//! In which order the bytes of a number stand.
enum class ByteOrder
{
    little,
    big
};

//! Numbers of a type out of bytes, as many as there are whole ones.
template <class Number>
std::vector<double> numbers_in(std::string_view bytes, ByteOrder order)
{
    static_assert(std::endian::native == std::endian::little);
    std::vector<double> numbers;
    numbers.reserve(bytes.size() / sizeof(Number));
    for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number)) {
        std::array<char, sizeof(Number)> raw;
        std::memcpy(raw.data(), bytes.data() + at, sizeof(Number));
        if (order == ByteOrder::big)
            std::reverse(raw.begin(), raw.end());
        numbers.push_back(static_cast<double>(std::bit_cast<Number>(raw)));
    }
    return numbers;
}

//! A type of numbers by its names in both kinds of VTK file.
struct VtkType
{
    std::string_view xml_name, legacy_name, other_legacy_name;
    std::size_t size; //!< [bytes]
    std::vector<double> (*numbers)(std::string_view, ByteOrder);
};
inline constexpr VtkType vtk_types[] = {
    {"Float32", "float", "", 4, numbers_in<float>},
    {"Float64", "double", "", 8, numbers_in<double>},
    {"Int8", "char", "signed_char", 1, numbers_in<std::int8_t>},
    {"UInt8", "unsigned_char", "", 1, numbers_in<std::uint8_t>},
    {"Int16", "short", "", 2, numbers_in<std::int16_t>},
    {"UInt16", "unsigned_short", "", 2, numbers_in<std::uint16_t>},
    {"Int32", "int", "vtktypeint32", 4, numbers_in<std::int32_t>},
    {"UInt32", "unsigned_int", "vtktypeuint32", 4, numbers_in<std::uint32_t>},
    {"Int64", "long", "vtktypeint64", 8, numbers_in<std::int64_t>},
    {"UInt64", "unsigned_long", "vtktypeuint64", 8, numbers_in<std::uint64_t>},
};

//! \throws InputError
inline VtkType const& vtk_type(std::string_view name, std::string const& origin)
{
    for (auto const& type : vtk_types)
        if (name == type.xml_name || name == type.legacy_name ||
            (!name.empty() && name == type.other_legacy_name))
            return type;
    throw InputError(fmt::format("{}: \"{}\" is not a type of numbers that is read", origin, name));
}

} // namespace demens::observe::frame_file
