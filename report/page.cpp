#include "report/page.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

namespace demens::report {

//! report/page with style, scripts and Vega in their places; made by embed_page.cmake when the project is
//! built.
extern std::string_view const page_template;

namespace {

std::string escape_html(std::string const& text)
{
    std::string escaped;
    for (char c : text) {
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        default:
            escaped += c;
        }
    }
    return escaped;
}

//! JSON that no text inside can end the script element with; NaN becomes null.
std::string embeddable(nlohmann::json const& document)
{
    std::string const plain = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string safe;
    safe.reserve(plain.size());
    for (char c : plain) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

void replace_mark(std::string& page, std::string_view mark, std::string const& text)
{
    page.replace(page.find(mark), mark.size(), text);
}

} // namespace

std::string page_of(nlohmann::json const& document, std::string const& title)
{
    std::string page(page_template);
    replace_mark(page, "{{title}}", escape_html(title));
    replace_mark(page, "{{document}}", embeddable(document));
    return page;
}

} // namespace demens::report
