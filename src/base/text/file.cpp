#include "demens/base/text/file.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace demens::text {

std::string read_file(std::filesystem::path const& file, std::string const& what)
{
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{}: there is no such {}, or it cannot be read", file.string(), what));
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

std::string plain_text(std::string const& content, std::string const& origin)
{
    bool const utf16 = content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
    if (utf16 || content.find('\0') != std::string::npos)
        throw InputError(fmt::format("{}: is {}, not plain text; save it as UTF-8 or ASCII", origin,
                                     utf16 ? "UTF-16" : "binary"));
    std::string text;
    text.reserve(content.size());
    for (std::size_t k = content.starts_with("\xEF\xBB\xBF") ? 3 : 0; k < content.size(); ++k) {
        if (content[k] != '\r')
            text += content[k];
        else if (k + 1 == content.size() || content[k + 1] != '\n')
            text += '\n';
    }
    return text;
}

std::string trimmed(std::string_view text)
{
    constexpr std::string_view unbreakable = "\xC2\xA0"; // in UTF-8
    constexpr std::string_view blanks = " \t\n";
    for (std::size_t before = text.size() + 1; before != text.size();) {
        before = text.size();
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        text.remove_suffix(text.size() - (text.find_last_not_of(blanks) + 1));
        if (text.starts_with(unbreakable))
            text.remove_prefix(unbreakable.size());
        if (text.ends_with(unbreakable))
            text.remove_suffix(unbreakable.size());
    }
    return std::string(text);
}

std::string lower_case(std::string_view text)
{
    std::string result(text);
    for (char& letter : result)
        if (letter >= 'A' && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    return result;
}

} // namespace demens::text
