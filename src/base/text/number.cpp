#include "demens/base/text/number.hpp"

#include "demens/base/text/file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace demens::text {

std::optional<double> number_of(std::string_view text, DecimalMark mark)
{
    constexpr std::string_view minus = "\xE2\x88\x92"; // the sign of typesetters, in UTF-8
    std::string digits = trimmed(text);
    if (digits.starts_with(minus))
        digits.replace(0, minus.size(), "-");
    if (digits.starts_with('+'))
        digits.erase(0, digits.starts_with("+-") ? 0 : 1);
    bool const has_comma = digits.find(',') != std::string::npos;
    if (has_comma && (mark == DecimalMark::point || digits.find('.') != std::string::npos))
        return std::nullopt;
    for (char& c : digits) {
        if (c == ',')
            c = '.';
        if (c == 'd' || c == 'D')
            c = 'e';
    }
    double value = 0;
    auto const* end = digits.data() + digits.size();
    auto const [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

bool means_missing(std::string_view text)
{
    constexpr std::array words = {"",       "na",      "n/a", "nan",  "null",    "none",  "missing",
                                  "-",      "--",      "?",   "#n/a", "#value!", "#ref!", "#num!",
                                  "#name?", "#div/0!", ".",   "#na",  "#null!"};
    auto const word = lower_case(trimmed(text));
    return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace demens::text
