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

//! The runs of each wave as rows under one list of keys, since many runs would repeat the keys many times.
nlohmann::json with_rows_of_runs(nlohmann::json document)
{
    for (auto& wave : document["waves"]) {
        auto& runs = wave["runs"];
        nlohmann::json keys = nlohmann::json::array(), rows = nlohmann::json::array();
        for (auto const& run : runs) {
            if (keys.empty())
                for (auto const& [key, value] : run.items())
                    keys.push_back(key);
            nlohmann::json row = nlohmann::json::array();
            for (auto const& [key, value] : run.items())
                row.push_back(value);
            rows.push_back(std::move(row));
        }
        runs = {{"keys", std::move(keys)}, {"rows", std::move(rows)}};
    }
    return document;
}

} // namespace

std::string page_of(nlohmann::json const& document, std::string const& title)
{
    // Marks are found in the template alone: what is put in may hold them, too.
    std::string_view const title_mark = "{{title}}", document_mark = "{{document}}";
    auto const title_place = page_template.find(title_mark);
    auto const document_place = page_template.find(document_mark, title_place);
    std::string page(page_template.substr(0, title_place));
    page += escape_html(title);
    auto const between = title_place + title_mark.size();
    page += page_template.substr(between, document_place - between);
    page += embeddable(with_rows_of_runs(document));
    page += page_template.substr(document_place + document_mark.size());
    return page;
}

} // namespace demens::report
