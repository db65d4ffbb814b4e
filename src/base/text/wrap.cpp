#include "demens/base/text/wrap.hpp"

#include <algorithm>

namespace demens::text {
namespace {

//! Bytes that begin a character of UTF-8.
std::size_t columns_of(std::string const& text)
{
    std::size_t count = 0;
    for (char const c : text)
        count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    return count;
}

} // namespace

std::string wrapped(std::string const& line, std::size_t width, std::size_t indent)
{
    constexpr std::size_t narrowest = 20; // of what is left beside the indent
    if (width == 0 || columns_of(line) <= width)
        return line;
    if (width < indent + narrowest)
        indent = width > narrowest ? width - narrowest : 0;
    std::string all, current;
    auto const begin = line.find_first_not_of(' ');
    std::string pending =
        begin == std::string::npos ? "" : line.substr(0, begin); // blanks before the next word
    for (std::size_t at = pending.size(); at < line.size();) {
        auto const end = std::min(line.find(' ', at), line.size());
        auto const word = line.substr(at, end - at);
        bool const is_first = current.find_first_not_of(' ') == std::string::npos;
        if (!is_first && columns_of(current) + columns_of(pending) + columns_of(word) > width) {
            all += current + "\n";
            current = std::string(indent, ' ') + word;
        } else {
            current += pending + word;
        }
        auto const next = std::min(line.find_first_not_of(' ', end), line.size());
        pending = line.substr(end, next - end);
        at = next;
    }
    return all + current;
}

} // namespace demens::text
