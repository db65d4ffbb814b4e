#include "ensemble/input/toml_file.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string_view>

namespace demens::ensemble::input {

std::string read_text(std::filesystem::path const& file, std::string const& what_to_give)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{}: cannot be read; give {}", file.string(), what_to_give));
    return {std::istreambuf_iterator<char>(stream), {}};
}

namespace {

//! What a file is that somebody gave in the place of TOML; empty: perhaps it is some.
std::string other_than_toml(std::string_view text)
{
    if (text.starts_with("\x89HDF"))
        return "an HDF5 file, e.g. a campaign file, and no TOML file: look at it with `demens status`, "
               "change it with "
               "`demens extend`";
    if (text.find('\0') != std::string_view::npos)
        return "binary, and no TOML file, which is plain text";
    return "";
}

//! Whether the first line that says something reads like one of a table: TOML has a bracket or `key =`.
bool begins_like_a_table(std::string_view text)
{
    while (!text.empty()) {
        auto const line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        auto const first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos || line[first] == '#')
            continue;
        return line[first] != '[' && line.find('=') == std::string_view::npos &&
               line.find_first_of(",;\t") != std::string_view::npos;
    }
    return false;
}

} // namespace

toml::table parse_toml(std::string const& text, std::string const& origin)
{
    if (auto const other = other_than_toml(text); !other.empty())
        throw InputError(fmt::format("{}: is {}", origin, other));
    if (begins_like_a_table(text))
        throw InputError(
            fmt::format("{}:1: is a table, and no TOML file, which has lines `key = value`: give the TOML "
                        "file, and name the table in it",
                        origin));
    try {
        return toml::parse(text, origin);
    } catch (toml::parse_error const& error) {
        auto const& where = error.source().begin;
        throw InputError(fmt::format("{}:{}: column {}: not TOML: {}", origin, where.line, where.column,
                                     error.description()));
    }
}

} // namespace demens::ensemble::input
