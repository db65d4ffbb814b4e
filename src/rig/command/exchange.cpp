#include "src/rig/command/exchange.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "demens/base/text/csv.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <regex>
#include <sstream>

namespace demens::rig::command {
namespace {

std::string content_of(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw InputError(fmt::format("the command has written no {}", file.filename().string()));
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

//! The number behind `"NAME":` in an object; NaN where there is none.
double number_in_json(std::string const& text, std::string const& name)
{
    auto const key = "\"" + name + "\"";
    auto at = text.find(key);
    if (at == std::string::npos)
        return not_a_number;
    at = text.find_first_not_of(" \t\r\n", at + key.size());
    if (at == std::string::npos || text[at] != ':')
        return not_a_number;
    at = text.find_first_not_of(" \t\r\n", at + 1);
    if (at == std::string::npos)
        return not_a_number;
    auto const end = text.find_first_of(",}] \t\r\n", at);
    return text::number_of(text.substr(at, end - at)).value_or(not_a_number);
}

} // namespace

std::string parameters_json(Parameters const& parameters, std::uint64_t seed)
{
    auto text = fmt::format("{{\n \"seed\": {},\n \"parameters\": {{", seed);
    char const* before = "\n";
    for (auto const& [name, value] : parameters) {
        text += fmt::format("{}  \"{}\": {}", before, name, value);
        before = ",\n";
    }
    return text + "\n }\n}\n";
}

std::string filled(std::string const& text, Parameters const& parameters, std::uint64_t seed)
{
    std::string result;
    std::size_t from = 0;
    for (;;) {
        auto const open = text.find("${", from), close = text.find('}', open);
        if (open == std::string::npos || close == std::string::npos)
            return result + text.substr(from);
        result += text.substr(from, open - from);
        auto const name = text.substr(open + 2, close - open - 2);
        auto const found = parameters.find(name);
        if (name == "seed")
            result += fmt::format("{}", seed);
        else if (found != parameters.end())
            result += fmt::format("{}", found->second);
        else
            throw InputError(fmt::format("${{{}}} is no parameter of the experiment; give it a table "
                                         "[[experiment.parameter]]",
                                         name));
        from = close + 1;
    }
}

std::vector<double> read_results(std::filesystem::path const& file, std::vector<std::string> const& names)
{
    std::vector<double> values;
    auto const text = content_of(file);
    if (file.extension() == ".csv") {
        auto const table = text::CsvTable::from_text(text, file.filename().string());
        for (auto const& name : names) {
            auto const column = table.find(name);
            values.push_back(column && table.rows() > 0 ? table.number(table.rows() - 1, *column)
                                                        : not_a_number);
        }
        return values;
    }
    for (auto const& name : names)
        values.push_back(number_in_json(text, name));
    return values;
}

Series read_series(std::filesystem::path const& file)
{
    auto const table = text::CsvTable::from_text(content_of(file), file.filename().string());
    Series series;
    for (std::size_t k = 0; k < table.names().size(); ++k) {
        auto const& name = table.names()[k];
        auto const open = name.find(" ["), close = name.find(']', open);
        bool const has_unit = open != std::string::npos && close != std::string::npos;
        series.names.push_back(k == 0 ? "time" : has_unit ? name.substr(0, open) : name);
        series.units.push_back(has_unit ? name.substr(open + 2, close - open - 2) : k == 0 ? "s" : "1");
        series.columns.push_back(table.numbers(static_cast<int>(k)));
    }
    return series;
}

std::string last_line(std::filesystem::path const& file, std::size_t longest)
{
    std::ifstream in(file);
    std::string line, last;
    while (std::getline(in, line))
        if (line.find_first_not_of(" \t\r") != std::string::npos)
            last = line;
    return last.substr(0, longest);
}

} // namespace demens::rig::command
