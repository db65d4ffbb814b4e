#include "ensemble/input/toml_file.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace demens::ensemble::input {

std::string read_text(std::filesystem::path const& file, std::string const& what_to_give)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{}: cannot be read; give {}", file.string(), what_to_give));
    return {std::istreambuf_iterator<char>(stream), {}};
}

toml::table parse_toml(std::string const& text, std::string const& origin)
{
    try {
        return toml::parse(text, origin);
    } catch (toml::parse_error const& error) {
        auto const& where = error.source().begin;
        throw InputError(fmt::format("{}:{}: column {}: not TOML: {}", origin, where.line, where.column,
                                     error.description()));
    }
}

} // namespace demens::ensemble::input
