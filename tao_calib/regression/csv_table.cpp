#include "tao_calib/regression/csv_table.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <limits>
#include <sstream>

namespace demens::tao_calib {
namespace {

std::string trimmed(std::string const& text)
{
    auto const first = text.find_first_not_of(" \t\r\"");
    if (first == std::string::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> fields_of(std::string const& line)
{
    std::vector<std::string> fields;
    std::size_t start = 0;
    while (start != std::string::npos) {
        auto const comma = line.find(',', start);
        fields.push_back(trimmed(line.substr(start, comma - start)));
        start = comma == std::string::npos ? comma : comma + 1;
    }
    return fields;
}

bool means_missing(std::string const& field)
{
    return field.empty() || field == "NA" || field == "NaN" || field == "nan";
}

} // namespace

CsvTable CsvTable::from_file(std::filesystem::path const& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw InputError(fmt::format("{}: cannot be read", file.string()));
    std::ostringstream text;
    text << stream.rdbuf();
    return from_text(text.str(), file.string());
}

CsvTable CsvTable::from_text(std::string const& text, std::string const& origin)
{
    CsvTable table;
    table.origin_ = origin;
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (trimmed(line).empty() || trimmed(line)[0] == '#')
            continue;
        auto const fields = fields_of(line);
        if (table.names_.empty()) {
            table.names_ = fields;
            for (auto name = fields.begin(); name != fields.end(); ++name)
                if (std::find(fields.begin(), name, *name) != name)
                    throw InputError(
                        fmt::format("{}:{}: two columns are called `{}`", origin, number, *name));
            table.columns_.resize(fields.size());
            continue;
        }
        if (fields.size() != table.names_.size())
            throw InputError(fmt::format("{}:{}: {} values for {} columns", origin, number, fields.size(),
                                         table.names_.size()));
        for (std::size_t k = 0; k < fields.size(); ++k) {
            double value = std::numeric_limits<double>::quiet_NaN();
            auto const* end = fields[k].data() + fields[k].size();
            if (!means_missing(fields[k]))
                if (auto const [stop, error] = std::from_chars(fields[k].data(), end, value);
                    error != std::errc() || stop != end)
                    throw InputError(fmt::format("{}:{}: `{}` in column `{}` is not a number", origin, number,
                                                 fields[k], table.names_[k]));
            table.columns_[k].push_back(value);
        }
        table.lines_.push_back(number);
    }
    if (table.lines_.empty())
        throw InputError(
            fmt::format("{}: holds no rows; a line of column names and rows of numbers are needed", origin));
    return table;
}

Eigen::VectorXd CsvTable::column(std::string const& name) const
{
    auto const place = std::find(names_.begin(), names_.end(), name);
    if (place == names_.end())
        throw InputError(
            fmt::format("{} has no column `{}`; its columns are {}", origin_, name, fmt::join(names_, ", ")));
    auto const& values = columns_[static_cast<std::size_t>(place - names_.begin())];
    return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace demens::tao_calib
