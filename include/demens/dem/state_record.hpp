#pragma once

#include "demens/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace demens::dem {

//! What the numbers of an array are.
enum class ElementType : std::uint32_t
{
    byte,
    uint32,
    int64,
    float32,
    float64
};
template <class T>
constexpr ElementType element_type()
{
    if constexpr (sizeof(T) == 1)
        return ElementType::byte;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return ElementType::uint32;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return ElementType::int64;
    else if constexpr (std::is_same_v<T, float>)
        return ElementType::float32;
    else {
        static_assert(std::is_same_v<T, double>);
        return ElementType::float64;
    }
}

//! The whole state of a simulation as named, typed arrays. As bytes it can be written and read back by a
//! machine of the same byte order: a mark, the version, the length and a checksum come first.
class StateRecord
{
  public:
    static constexpr std::uint32_t version = 1;

    struct Array
    {
        std::string name; //!< e.g. `particles/place`
        ElementType type;
        std::uint32_t columns; //!< numbers of a row
        std::vector<std::byte> data;
    };

    //! Adds an array of rows; numbers of one row follow each other.
    template <class T>
    void put(std::string name, std::span<T const> numbers, std::uint32_t columns = 1)
    {
        auto const bytes = std::as_bytes(numbers);
        arrays_.push_back({std::move(name), element_type<T>(), columns, {bytes.begin(), bytes.end()}});
    }
    //! The numbers of an array. \throws InputError where it is missing or of another type or width.
    template <class T>
    std::vector<T> get(std::string_view name, std::uint32_t columns = 1) const
    {
        Array const& array = find(name, element_type<T>(), columns);
        std::vector<T> numbers(array.data.size() / sizeof(T));
        if (!numbers.empty())
            std::memcpy(numbers.data(), array.data.data(), array.data.size());
        return numbers;
    }
    bool has(std::string_view name) const;
    std::vector<Array> const& arrays() const { return arrays_; }

    std::vector<std::byte> to_bytes() const;
    //! \throws InputError for what is no record, damaged, cut short, or of another version or byte order.
    static StateRecord from_bytes(std::span<std::byte const> bytes);

  private:
    Array const& find(std::string_view name, ElementType type, std::uint32_t columns) const;

    std::vector<Array> arrays_;
};

} // namespace demens::dem
