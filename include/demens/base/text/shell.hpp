#pragma once

#include <string>

namespace demens::text {

//! A word as a shell reads it back: as it is, or in single quotes where it holds more than letters, digits
//! and ./_-+=:@%
inline std::string shell_word(std::string const& word)
{
    auto const plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string("./_-+=:@%,").find(c) != std::string::npos;
    };
    bool quoted = word.empty();
    std::string text = "'";
    for (char const c : word) {
        quoted = quoted || !plain(c);
        text += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return quoted ? text + "'" : word;
}

} // namespace demens::text
