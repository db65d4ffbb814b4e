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

std::string option_text(OptionValue const& value)
{
    struct
    {
        std::string operator()(double v) const { return number_text(v); }
        std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::string const& v) const { return quoted(v); }
        std::string operator()(Vector3 const& v) const
        {
            return fmt::format("[{}, {}, {}]", number_text(v.x), number_text(v.y), number_text(v.z));
        }
        std::string operator()(std::vector<std::string> const& v) const
        {
            std::string words;
            for (auto const& word : v)
                words += (words.empty() ? "" : ", ") + quoted(word);
            return "[" + words + "]";
        }
    } const text;
    return std::visit(text, value);
}

} // namespace demens::ensemble::input
