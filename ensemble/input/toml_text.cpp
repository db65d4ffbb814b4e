#include "ensemble/input/toml_text.hpp"

#include <fmt/format.h>
#include <sstream>
#include <toml++/toml.h>

namespace demens::ensemble::input {

std::string quoted(std::string const& text)
{
    std::ostringstream out;
    out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none);
    return out.str();
}

std::string number_text(double value)
{
    auto text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos)
        text += ".0";
    return text;
}

} // namespace demens::ensemble::input
