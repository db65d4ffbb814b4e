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
    constexpr std::size_t width = sizeof(typename RecordRow<T>::Element);
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % width == 0);
    return sizeof(T) / width;
}

//! How a single number is kept: a bool as a byte, most integers as int64.
template <class T>
using KeptNumber = std::conditional_t<
    std::is_same_v<T, bool>, std::uint8_t,
    std::conditional_t<std::is_integral_v<T> && !std::is_same_v<T, std::uint32_t>, std::int64_t, T>>;

//! Adds what it visits to a record. A function that visits all fields of a state with a writer or a reader
//! is the one place that lists them.
class RecordWriter
{
  public:
    //! \param prefix of all names
    explicit RecordWriter(StateRecord& record, std::string prefix = {})
        : record_(record), prefix_(std::move(prefix))
    {
    }

    template <class T>
    void operator()(std::string const& name, std::vector<T> const& rows) const
    {
        using Element = typename RecordRow<T>::Element;
        record_.put(prefix_ + name,
                    std::span(reinterpret_cast<Element const*>(rows.data()), rows.size() * columns_of<T>()),
                    columns_of<T>());
    }
    template <class T>
    void operator()(std::string const& name, T const& value) const
    {
        (*this)(name, std::vector<KeptNumber<T>>{static_cast<KeptNumber<T>>(value)});
    }
    void operator()(std::string const& name, std::string const& text) const
    {
        record_.put(prefix_ + name, std::span<char const>(text));
    }
    //! How many of something are visited next, each by itself.
    template <class Many>
    void count(std::string const& name, Many const& many) const
    {
        (*this)(name, many.size());
    }

  private:
    StateRecord& record_;
    std::string prefix_;
};

//! Fills what it visits from a record. \throws InputError where an array is missing or has another form.
class RecordReader
{
  public:
    explicit RecordReader(StateRecord const& record, std::string prefix = {})
        : record_(record), prefix_(std::move(prefix))
    {
    }

    template <class T>
    void operator()(std::string const& name, std::vector<T>& rows) const
    {
        auto const numbers = record_.get<typename RecordRow<T>::Element>(prefix_ + name, columns_of<T>());
        rows.resize(numbers.size() / columns_of<T>());
        if (!rows.empty())
            std::memcpy(static_cast<void*>(rows.data()), numbers.data(), rows.size() * sizeof(T));
    }
    template <class T>
    void operator()(std::string const& name, T& value) const
    {
        std::vector<KeptNumber<T>> rows;
        (*this)(name, rows);
        if (rows.size() != 1)
            throw InputError(
                fmt::format("the array {}{} of the state record has {} rows, where one is needed", prefix_,
                            name, rows.size()));
        value = static_cast<T>(rows.front());
    }
    void operator()(std::string const& name, std::string& text) const
    {
        auto const letters = record_.get<char>(prefix_ + name);
        text.assign(letters.begin(), letters.end());
    }
    template <class Many>
    void count(std::string const& name, Many& many) const
    {
        std::int64_t size = 0;
        (*this)(name, size);
        if (size < 0 || size > 1'000'000)
            throw InputError(fmt::format("the state record has {} {}{}", size, prefix_, name));
        many.resize(static_cast<std::size_t>(size));
    }

  private:
    StateRecord const& record_;
    std::string prefix_;
};

//! \throws InputError with what does not fit in a record.
inline void expect_fit(bool fits, std::string_view what)
{
    if (!fits)
        throw InputError(fmt::format("the state record does not fit together: {}", what));
}

} // namespace demens::dem
