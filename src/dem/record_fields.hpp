#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/state_record.hpp"
#include "demens/dem/wall.hpp"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

namespace demens::dem {

//! How a type is kept in an array: so many numbers of one type; a record of a body is kept as doubles.
template <class T>
struct RecordRow
{
    using Element = std::conditional_t<std::is_arithmetic_v<T>, T, double>;
};
template <class T>
constexpr std::uint32_t columns_of()
{
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(typename RecordRow<T>::Element) == 0);
    return sizeof(T) / sizeof(typename RecordRow<T>::Element);
}

//! Adds what it visits to a record. A function that visits all fields of a state with a writer or a reader
//! is the one place that lists them.
class RecordWriter
{
  public:
    explicit RecordWriter(StateRecord& record) : record_(record) {}

    template <class T>
    void operator()(std::string name, std::vector<T> const& rows)
    {
        using Element = typename RecordRow<T>::Element;
        record_.put(std::move(name),
                    std::span(reinterpret_cast<Element const*>(rows.data()), rows.size() * columns_of<T>()),
                    columns_of<T>());
    }
    template <class T>
    void operator()(std::string name, T const& value)
    {
        if constexpr (std::is_same_v<T, bool>)
            (*this)(std::move(name), std::vector<std::uint8_t>{value});
        else if constexpr (std::is_same_v<T, std::size_t> || std::is_same_v<T, int>)
            (*this)(std::move(name), std::vector<std::int64_t>{static_cast<std::int64_t>(value)});
        else
            (*this)(std::move(name), std::vector<T>{value});
    }

  private:
    StateRecord& record_;
};

//! Fills what it visits from a record. \throws InputError where an array is missing or has another form.
class RecordReader
{
  public:
    explicit RecordReader(StateRecord const& record) : record_(record) {}

    template <class T>
    void operator()(std::string const& name, std::vector<T>& rows)
    {
        auto const numbers = record_.get<typename RecordRow<T>::Element>(name, columns_of<T>());
        rows.resize(numbers.size() / columns_of<T>());
        if (!rows.empty())
            std::memcpy(static_cast<void*>(rows.data()), numbers.data(), rows.size() * sizeof(T));
    }
    template <class T>
    void operator()(std::string const& name, T& value)
    {
        if constexpr (std::is_same_v<T, bool>)
            value = only<std::uint8_t>(name) != 0;
        else if constexpr (std::is_same_v<T, std::size_t> || std::is_same_v<T, int>)
            value = static_cast<T>(only<std::int64_t>(name));
        else
            value = only<T>(name);
    }

  private:
    template <class T>
    T only(std::string const& name)
    {
        std::vector<T> rows;
        (*this)(name, rows);
        if (rows.size() != 1)
            throw InputError(fmt::format("the array {} of the state record has {} rows, where one is needed",
                                         name, rows.size()));
        return rows.front();
    }

    StateRecord const& record_;
};

//! \throws InputError with what does not fit in a record.
inline void expect_fit(bool fits, std::string_view what)
{
    if (!fits)
        throw InputError(fmt::format("the state record does not fit together: {}", what));
}

} // namespace demens::dem
