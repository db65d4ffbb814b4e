#pragma once

#include "demens/base/contract.hpp"
#include "demens/dem/team.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace demens::dem {

//! Appends plain values to bytes.
class ByteWriter
{
  public:
    explicit ByteWriter(Team::Bytes& bytes) : bytes_(bytes) {}

    template <class T>
    void put(T const* values, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        auto const* from = reinterpret_cast<std::byte const*>(values);
        bytes_.insert(bytes_.end(), from, from + count * sizeof(T));
    }
    template <class T>
    void put(T const& value)
    {
        put(&value, 1);
    }
    //! A part that is read by itself.
    void put_part(Team::Bytes const& part)
    {
        put(static_cast<std::uint64_t>(part.size()));
        put(part.data(), part.size());
    }

  private:
    Team::Bytes& bytes_;
};

//! Takes them out again, in the same order.
class ByteReader
{
  public:
    explicit ByteReader(Team::Bytes const& bytes) : bytes_(bytes) {}

    bool at_end() const { return at_ == bytes_.size(); }

    template <class T>
    void get(T* values, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        DEMENS_EXPECT(count * sizeof(T) <= bytes_.size() - at_, "no more is read than was written");
        if (count > 0)
            std::memcpy(static_cast<void*>(values), bytes_.data() + at_, count * sizeof(T));
        at_ += count * sizeof(T);
    }
    template <class T>
    T get()
    {
        T value;
        get(&value, 1);
        return value;
    }
    Team::Bytes get_part()
    {
        Team::Bytes part(get<std::uint64_t>());
        get(part.data(), part.size());
        return part;
    }

  private:
    Team::Bytes const& bytes_;
    std::size_t at_ = 0;
};

} // namespace demens::dem
