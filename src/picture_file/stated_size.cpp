#include "src/picture_file/stated_size.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace demens::picture_file {
namespace {

std::uint64_t byte_at(std::string_view content, std::size_t place)
{
    return place < content.size() ? static_cast<unsigned char>(content[place]) : 0;
}

std::uint64_t big_endian(std::string_view content, std::size_t place, int bytes)
{
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i)
        value = value << 8 | byte_at(content, place + static_cast<std::size_t>(i));
    return value;
}

std::uint64_t little_endian(std::string_view content, std::size_t place, int bytes)
{
    std::uint64_t value = 0;
    for (int i = bytes; i-- > 0;)
        value = value << 8 | byte_at(content, place + static_cast<std::size_t>(i));
    return value;
}

//! Start of frame; C4, C8 and CC are other things (ITU-T T.81, table B.1).
bool is_start_of_frame(std::uint64_t marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

bool has_no_length(std::uint64_t marker)
{
    return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

} // namespace

std::uint64_t stated_pixels_of_png(std::string_view content)
{
    return big_endian(content, 16, 4) * big_endian(content, 20, 4);
}

std::uint64_t stated_pixels_of_jpeg(std::string_view content)
{
    std::uint64_t constexpr start_of_scan = 0xda, fill = 0xff;
    std::uint64_t largest = 0;
    for (std::size_t place = 2; place + 1 < content.size();) {
        if (byte_at(content, place) != fill || byte_at(content, place + 1) == 0 ||
            byte_at(content, place + 1) == fill) {
            ++place; // garbage, which readers skip
            continue;
        }
        auto const marker = byte_at(content, place + 1);
        place += 2;
        if (marker == start_of_scan)
            break;
        if (has_no_length(marker))
            continue;
        if (is_start_of_frame(marker))
            largest =
                std::max(largest, big_endian(content, place + 3, 2) * big_endian(content, place + 5, 2));
        place += std::max<std::uint64_t>(2, big_endian(content, place, 2));
    }
    return largest;
}

std::uint64_t stated_pixels_of_bmp(std::string_view content)
{
    std::uint64_t constexpr oldest_header = 12; // of OS/2
    if (little_endian(content, 14, 4) == oldest_header)
        return little_endian(content, 18, 2) * little_endian(content, 20, 2);
    auto const columns = static_cast<std::int32_t>(little_endian(content, 18, 4));
    auto const rows = static_cast<std::int32_t>(little_endian(content, 22, 4)); // negative: from the top
    return static_cast<std::uint64_t>(std::llabs(columns)) * static_cast<std::uint64_t>(std::llabs(rows));
}

} // namespace demens::picture_file
