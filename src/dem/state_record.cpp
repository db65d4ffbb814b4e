#include "demens/dem/state_record.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

namespace demens::dem {
namespace {

constexpr std::array<char, 8> mark = {'D', 'E', 'M', 'S', 'T', 'A', 'T', 'E'};
constexpr std::uint32_t byte_order = 0x01020304; //!< reads otherwise where bytes are the other way round

std::size_t size_of(ElementType type)
{
    constexpr std::array<std::size_t, 5> sizes = {1, 4, 8, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
char const* name_of(ElementType type)
{
    constexpr std::array<char const*, 5> names = {"bytes", "uint32", "int64", "float32", "float64"};
    return names[static_cast<std::size_t>(type)];
}

//! Checksum of the content (Fowler, Noll and Vo, 64 bit, a word of eight bytes at a time).
std::uint64_t checksum(std::span<std::byte const> bytes)
{
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
        sum = (sum ^ word) * 0x100000001b3u;
        sum ^= sum >> 29;
    }
    return sum;
}

//! Before the arrays.
struct Header
{
    std::array<char, 8> mark;
    std::uint32_t byte_order, version;
    std::uint64_t length, checksum; //!< of what follows
};

void append(std::vector<std::byte>& bytes, void const* from, std::size_t count)
{
    std::size_t const at = bytes.size();
    bytes.resize(at + count);
    if (count > 0)
        std::memcpy(bytes.data() + at, from, count);
}
template <class T>
void append(std::vector<std::byte>& bytes, T const& value)
{
    append(bytes, &value, sizeof(T));
}

//! Takes the content apart.
class Content
{
  public:
    explicit Content(std::span<std::byte const> bytes) : left_(bytes) {}

    bool at_end() const { return left_.empty(); }
    std::span<std::byte const> take(std::uint64_t count)
    {
        if (count > left_.size())
            throw InputError("the state record is damaged: an array is longer than what is there");
        auto const taken = left_.first(static_cast<std::size_t>(count));
        left_ = left_.subspan(static_cast<std::size_t>(count));
        return taken;
    }
    template <class T>
    T number()
    {
        T value;
        std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
        return value;
    }

  private:
    std::span<std::byte const> left_;
};

StateRecord::Array read_array(Content& content)
{
    StateRecord::Array array;
    auto const name = content.take(content.number<std::uint32_t>());
    array.name.assign(reinterpret_cast<char const*>(name.data()), name.size());
    auto const type = content.number<std::uint32_t>();
    array.type = static_cast<ElementType>(type);
    array.columns = content.number<std::uint32_t>();
    auto const data = content.take(content.number<std::uint64_t>());
    if (type > static_cast<std::uint32_t>(ElementType::float64) || array.columns == 0 ||
        data.size() % (size_of(array.type) * array.columns) != 0)
        throw InputError(
            fmt::format("the state record is damaged: the array {} has no whole rows", array.name));
    array.data.assign(data.begin(), data.end());
    return array;
}

} // namespace

bool StateRecord::has(std::string_view name) const
{
    return std::any_of(arrays_.begin(), arrays_.end(), [&](Array const& a) { return a.name == name; });
}

StateRecord::Array const& StateRecord::find(std::string_view name, ElementType type,
                                            std::uint32_t columns) const
{
    auto const found =
        std::find_if(arrays_.begin(), arrays_.end(), [&](Array const& a) { return a.name == name; });
    if (found == arrays_.end())
        throw InputError(fmt::format("the state record lacks the array {}: it is not of a simulation with "
                                     "these options",
                                     name));
    if (found->type != type || found->columns != columns)
        throw InputError(fmt::format("the array {} of the state record has {} columns of {}, where {} of {} "
                                     "are needed",
                                     name, found->columns, name_of(found->type), columns, name_of(type)));
    return *found;
}

std::vector<std::byte> StateRecord::to_bytes() const
{
    std::vector<std::byte> bytes;
    append(bytes, Header{});
    for (Array const& array : arrays_) {
        append(bytes, static_cast<std::uint32_t>(array.name.size()));
        append(bytes, array.name.data(), array.name.size());
        append(bytes, array.type);
        append(bytes, array.columns);
        append(bytes, static_cast<std::uint64_t>(array.data.size()));
        append(bytes, array.data.data(), array.data.size());
    }
    auto const content = std::span(bytes).subspan(sizeof(Header));
    Header const header{mark, byte_order, version, content.size(), checksum(content)};
    std::memcpy(bytes.data(), &header, sizeof(Header));
    return bytes;
}

StateRecord StateRecord::from_bytes(std::span<std::byte const> bytes)
{
    Header header;
    if (bytes.size() < sizeof(Header))
        throw InputError(fmt::format("the state record is cut short: {} bytes, where the head alone has {}",
                                     bytes.size(), sizeof(Header)));
    std::memcpy(&header, bytes.data(), sizeof(Header));
    if (header.mark != mark)
        throw InputError("this is no state record of demens: its first bytes are others");
    if (header.byte_order != byte_order)
        throw InputError("the state record was written by a machine of another byte order");
    if (header.version != version)
        throw InputError(fmt::format("the state record has version {}, this program reads version {}; run "
                                     "the simulation again",
                                     header.version, version));
    auto const content = bytes.subspan(sizeof(Header));
    if (header.length != content.size())
        throw InputError(fmt::format("the state record is cut short or too long: {} bytes after its head, "
                                     "which names {}",
                                     content.size(), header.length));
    if (header.checksum != checksum(content))
        throw InputError("the state record is damaged: its checksum is another");
    StateRecord record;
    for (Content left(content); !left.at_end();)
        record.arrays_.push_back(read_array(left));
    return record;
}

} // namespace demens::dem
