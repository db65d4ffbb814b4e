#include "src/base/text/csv_records.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/file.hpp"
#include "demens/base/text/number.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::text {
namespace {

bool is_blank(std::vector<std::string> const& cells)
{
    return std::all_of(cells.begin(), cells.end(), [](auto const& cell) { return cell.empty(); });
}

//! Cells but for empty ones at the end.
std::size_t content_of(CsvRecord const& record)
{
    std::size_t count = record.cells.size();
    while (count > 0 && record.cells[count - 1].empty())
        --count;
    return count;
}

//! Columns that a separator makes of the first rows: of the first one, and whether the others agree.
struct Columns
{
    std::size_t count = 0;
    bool agree = true;
};

Columns columns_by(char separator, std::string const& text, std::string const& origin, CsvDialect const& from)
{
    constexpr int enough = 20;
    CsvRecords records(text, origin, separator, from.start, from.line);
    Columns columns;
    CsvRecord record;
    for (int seen = 0; seen < enough && records.next(record);) {
        if (record.comment)
            continue;
        auto const count = content_of(record);
        if (seen++ == 0)
            columns.count = count;
        columns.agree &=
            count <= columns.count && record.cells.size() + (separator == ' ' ? 0 : 1) >= columns.count;
    }
    return columns;
}

} // namespace

bool CsvRecords::next(CsvRecord& record)
{
    while (at_ < text_.size()) {
        record = {line_, {}};
        auto const start = std::min(text_.find_first_not_of(" \t\n", at_), text_.size());
        auto const line_end = std::min(text_.find('\n', at_), text_.size());
        bool const has_mark = start < line_end && text_[start] == '#';
        auto const word = has_mark ? text_.substr(start, text_.find_first_of(" ,;|\t\n", start) - start) : "";
        if (has_mark && !means_missing(word)) {
            std::string const rest = text_.substr(start + 1, line_end - start - 1);
            at_ = std::min(line_end + 1, text_.size());
            ++line_;
            std::string const no_quotes = rest.find('"') == std::string::npos ? rest : "";
            CsvRecords(no_quotes, origin_, separator_, 0, record.line).read(record);
            record.comment = true;
            return true;
        }
        read(record);
        if (!is_blank(record.cells))
            return true;
    }
    return false;
}

//! One record, with the end of its line.
void CsvRecords::read(CsvRecord& record)
{
    auto const skip_blanks = [&] {
        while (separator_ == ' ' && at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
            ++at_;
    };
    skip_blanks();
    for (bool more = true; more;) {
        if (separator_ == ' ' && !record.cells.empty() && (at_ == text_.size() || text_[at_] == '\n'))
            break;
        record.cells.push_back(read_cell());
        more = at_ < text_.size() && text_[at_] == separator_;
        if (more)
            ++at_;
        skip_blanks();
    }
    if (at_ < text_.size()) {
        ++at_;
        ++line_;
    }
}

//! Up to the separator or the end of the line.
std::string CsvRecords::read_cell()
{
    auto const content =
        std::min(text_.find_first_not_of(separator_ == '\t' ? " " : " \t", at_), text_.size());
    std::string cell;
    if (content < text_.size() && text_[content] == '"') {
        at_ = content;
        cell = read_quoted();
    }
    auto const end = [&] {
        for (auto k = at_; k < text_.size(); ++k)
            if (text_[k] == separator_ || text_[k] == '\n' || (separator_ == ' ' && text_[k] == '\t'))
                return k;
        return text_.size();
    }();
    cell += text_.substr(at_, end - at_);
    at_ = end;
    return trimmed(cell);
}

std::string CsvRecords::read_quoted()
{
    int const opened = line_;
    std::string cell;
    for (++at_; at_ < text_.size(); ++at_) {
        if (text_[at_] == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"')
            ++at_; // a quote within quotes is written twice
        else if (text_[at_] == '"') {
            ++at_;
            return cell;
        }
        line_ += text_[at_] == '\n';
        cell += text_[at_];
    }
    throw InputError(fmt::format("{}:{}: a quote is opened and not closed", origin_, opened));
}

CsvDialect csv_dialect(std::string const& text, std::string const& origin)
{
    CsvDialect dialect{','};
    if (lower_case(text.substr(0, 4)) == "sep=" && text.size() > 5 && (text[5] == '\n'))
        return {text[4], 6, 2};
    std::size_t most = 1;
    for (char const separator : {'\t', ';', '|', ',', ' '}) {
        Columns columns;
        try {
            columns = columns_by(separator, text, origin, dialect);
        } catch (InputError const&) {
            continue; // a quote that is one with another separator
        }
        if (columns.count > 1 && columns.agree)
            return {separator};
        if (columns.count > most && separator != ' ') {
            most = columns.count;
            dialect.separator = separator;
        }
    }
    return dialect;
}

} // namespace demens::text
