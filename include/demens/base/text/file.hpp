#pragma once

#include <filesystem>
#include <string>

namespace demens::text {

//! The bytes of a file. \param what the file is meant to be, for the message \throws InputError
std::string read_file(std::filesystem::path const& file, std::string const& what);

//! Text as programs on all systems write it, made plain: no byte order mark, every line ends in \n.
//! \throws InputError for an encoding that is not read (UTF-16)
std::string plain_text(std::string const& content, std::string const& origin);

//! Without blanks at both ends, the ones that do not break included.
std::string trimmed(std::string_view text);
//! With small letters, of the alphabet of 26 alone.
std::string lower_case(std::string_view text);

} // namespace demens::text
