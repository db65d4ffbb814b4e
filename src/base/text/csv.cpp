#include "demens/base/text/csv.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/file.hpp"
#include "src/base/text/csv_records.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace demens::text {
namespace {

bool is_number(std::string const& cell)
{
    return number_of(cell, DecimalMark::point) || number_of(cell, DecimalMark::comma);
}

//! Whether cells hold numbers, and none of them anything else.
bool all_numbers(std::vector<std::string> const& cells)
{
    return std::any_of(cells.begin(), cells.end(), is_number) &&
           std::all_of(cells.begin(), cells.end(),
                       [](auto const& c) { return is_number(c) || means_missing(c); });
}

//! Whether the comma may as well stand between thousands: 1,234 or 12,345,678.
bool looks_like_thousands(std::string_view cell)
{
    if (cell.starts_with('-') || cell.starts_with('+'))
        cell.remove_prefix(1);
    auto const first = cell.find(',');
    if (first == std::string_view::npos || first == 0 || first > 3 || cell.front() == '0')
        return false;
    for (std::size_t k = 0; k < cell.size(); ++k)
        if (k < first || (k - first) % 4 != 0 ? cell[k] < '0' || cell[k] > '9' : cell[k] != ',')
            return false;
    return (cell.size() - first) % 4 == 0;
}

std::string in_words(char separator)
{
    switch (separator) {
    case '\t':
        return "tabs";
    case ' ':
        return "blanks";
    case ';':
        return "semicolons";
    case ',':
        return "commas";
    default:
        return fmt::format("`{}`", separator);
    }
}

} // namespace

CsvTable CsvTable::from_file(std::filesystem::path const& file)
{
    return from_text(read_file(file, "table of comma-separated values"), file.string());
}

CsvTable CsvTable::from_text(std::string const& content, std::string const& origin,
                             std::vector<std::string> const& names)
{
    CsvTable table;
    table.origin_ = origin;
    auto const text = plain_text(content, origin);
    auto const dialect = csv_dialect(text, origin);
    table.separator_ = dialect.separator;
    CsvRecords records(text, origin, dialect.separator, dialect.start, dialect.line);
    Row last_comment{0, {}};
    for (CsvRecord record{0, {}}; records.next(record);) {
        Row row{record.line, std::move(record.cells)};
        if (record.comment) {
            last_comment = std::move(row);
        } else if (table.header_line_ > 0) {
            table.add(std::move(row));
        } else if (!all_numbers(row.cells)) {
            table.take_names(std::move(row));
        } else if (last_comment.cells.size() == row.cells.size() && !all_numbers(last_comment.cells)) {
            table.take_names(last_comment); // `#run,a,y`
            table.add(std::move(row));
        } else if (!names.empty()) {
            table.take_names({row.line, names});
            table.add(std::move(row));
        } else {
            throw InputError(
                fmt::format("{}:{}: holds numbers where the names of the columns are expected; begin "
                            "with a line of names",
                            origin, row.line));
        }
        record = {0, {}};
    }
    table.drop_empty_columns();
    table.find_decimal_mark();
    return table;
}

void CsvTable::take_names(Row header)
{
    header_line_ = header.line;
    names_ = std::move(header.cells);
    for (auto name = names_.begin(); name != names_.end(); ++name)
        if (!name->empty() && std::find(names_.begin(), name, *name) != name)
            throw InputError(
                fmt::format("{}:{}: two columns are called \"{}\"", origin_, header_line_, *name));
}

void CsvTable::add(Row row)
{
    auto named = names_.size();
    while (named > 0 && names_[named - 1].empty())
        --named;
    auto filled = row.cells.size();
    while (filled > names_.size() && row.cells[filled - 1].empty())
        --filled;
    if (filled < named || filled > names_.size())
        throw InputError(fmt::format(
            "{}:{}: has {} values where the header has {} columns, separated by {}{}", origin_, row.line,
            filled, named, in_words(separator_),
            separator_ == ',' && filled > names_.size()
                ? "; are there decimal commas? Then separate by semicolons, or put the numbers in quotes"
                : ""));
    row.cells.resize(names_.size());
    rows_.push_back(std::move(row));
}

//! What separators at the ends of lines make.
void CsvTable::drop_empty_columns()
{
    for (auto k = names_.size(); k-- > 0;) {
        bool const empty = names_[k].empty() && std::all_of(rows_.begin(), rows_.end(), [&](Row const& row) {
                               return row.cells[k].empty();
                           });
        if (!empty)
            continue;
        auto const place = static_cast<std::ptrdiff_t>(k);
        names_.erase(names_.begin() + place);
        for (auto& row : rows_)
            row.cells.erase(row.cells.begin() + place);
    }
}

//! Looks at columns that hold nothing but numbers.
void CsvTable::find_decimal_mark()
{
    std::string comma, point; // examples
    bool all_like_thousands = true;
    for (int k = 0; k < static_cast<int>(names_.size()); ++k) {
        std::string own_comma, own_point;
        bool numbers = true, like_thousands = true;
        for (int row = 0; row < this->rows() && numbers; ++row) {
            auto const& text = cell(row, k);
            numbers = is_number(text) || means_missing(text);
            if (!numbers || means_missing(text))
                continue;
            auto const example = fmt::format("`{}` in line {}", text, line_of_row(row));
            if (text.find(',') != std::string::npos) {
                own_comma = own_comma.empty() ? example : own_comma;
                like_thousands &= looks_like_thousands(text);
            } else if (text.find('.') != std::string::npos) {
                own_point = own_point.empty() ? example : own_point;
            }
        }
        if (!numbers)
            continue;
        comma = comma.empty() ? own_comma : comma;
        point = point.empty() ? own_point : point;
        all_like_thousands &= like_thousands;
    }
    if (comma.empty())
        return;
    mark_ = DecimalMark::comma;
    if (!point.empty())
        doubt_ = fmt::format("the file has decimal commas ({}) and points ({}); write all numbers in one way",
                             comma, point);
    else if (all_like_thousands && separator_ != ';')
        doubt_ = fmt::format("{} may be a decimal comma or one between thousands; write decimal points, and "
                             "nothing between thousands",
                             comma);
}

std::string CsvTable::where(int row) const
{
    return fmt::format("{}:{}", origin_, line_of_row(row));
}

std::optional<int> CsvTable::find(std::string const& name) const
{
    if (auto const place = std::find(names_.begin(), names_.end(), name); place != names_.end())
        return static_cast<int>(place - names_.begin());
    auto const same = [&](std::string const& other) {
        return lower_case(other) == lower_case(trimmed(name));
    };
    auto const place = std::find_if(names_.begin(), names_.end(), same);
    if (place == names_.end() || std::count_if(names_.begin(), names_.end(), same) > 1)
        return std::nullopt;
    return static_cast<int>(place - names_.begin());
}

int CsvTable::column(std::string const& name) const
{
    if (auto const place = find(name))
        return *place;
    throw InputError(fmt::format("{} has no column `{}`; its columns are {}{}", origin_, name,
                                 fmt::join(names_, ", "),
                                 names_.size() == 1 ? ": one column, of which no separator makes more" : ""));
}

bool CsvTable::is_numeric(int column) const
{
    return std::all_of(rows_.begin(), rows_.end(), [&](Row const& row) {
        return means_missing(row.cells[column]) || number_of(row.cells[column], mark_);
    });
}

double CsvTable::number(int row, int column) const
{
    auto const& text = cell(row, column);
    if (means_missing(text))
        return std::numeric_limits<double>::quiet_NaN();
    auto const refuse = [&](std::string const& why) {
        throw InputError(
            fmt::format("{}: column {}: \"{}\" is not a number{}", where(row), names_[column], text, why));
    };
    if (!doubt_.empty() && text.find_first_of(",.") != std::string::npos)
        refuse(" that is clear: " + doubt_);
    auto const value = number_of(text, mark_);
    if (!value && is_number(text))
        refuse(mark_ == DecimalMark::comma ? ": decimals follow a comma elsewhere in the file" : "");
    if (!value)
        refuse(looks_like_thousands(text) ? "; write nothing between thousands" : "");
    return *value;
}

std::vector<double> CsvTable::numbers(int column) const
{
    std::vector<double> values;
    for (int row = 0; row < rows(); ++row)
        values.push_back(number(row, column));
    return values;
}

std::string csv_quoted(std::string const& text)
{
    std::string cell = "\"";
    for (char const c : text) {
        cell += c;
        if (c == '"')
            cell += c;
    }
    return cell + '"';
}

} // namespace demens::text
