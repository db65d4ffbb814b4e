#pragma once

#include <filesystem>
#include <string>
#include <toml++/toml.h>

namespace demens::ensemble::input {

//! Text of a file. \throws InputError that says `what_to_give` when it cannot be read
std::string read_text(std::filesystem::path const& file, std::string const& what_to_give);
//! \param origin the file in messages \throws InputError with the place when it is not TOML
toml::table parse_toml(std::string const& text, std::string const& origin);

} // namespace demens::ensemble::input
