#pragma once

#include "demens/base/text/number.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace demens::text {

//! Cells in named columns, from text as spreadsheets and programs write it: a line of names, then a row a
//! line. Columns are separated by commas, semicolons, tabs, bars or blanks; cells may stand in quotes;
//! decimals follow a point or, throughout a file, a comma; lines that begin with # are comments. What nobody
//! asks for as a number may be any text.
class CsvTable
{
  public:
    //! \throws InputError with file and line where a row does not fit the names.
    static CsvTable from_file(std::filesystem::path const& file);
    //! The same from text; `origin` stands for the file in messages.
    //! \param names of the columns where the text begins with numbers; none: that is an error
    static CsvTable from_text(std::string const& text, std::string const& origin,
                              std::vector<std::string> const& names = {});

    std::string const& origin() const { return origin_; }
    //! Names of the columns, as written; empty where a column has none.
    std::vector<std::string> const& names() const { return names_; }
    int header_line() const { return header_line_; } //!< counted from 1
    int rows() const { return static_cast<int>(rows_.size()); }
    int line_of_row(int row) const { return rows_[row].line; } //!< counted from 1
    std::string where(int row) const;                          //!< `FILE:LINE`

    //! The column of that name, or of a name that differs in capitals alone; none: there is no such one.
    std::optional<int> find(std::string const& name) const;
    //! The same. \throws InputError that names the columns there are.
    int column(std::string const& name) const;

    std::string const& cell(int row, int column) const { return rows_[row].cells[column]; }
    bool is_missing(int row, int column) const { return means_missing(cell(row, column)); }
    //! Whether every cell that is not missing holds a number.
    bool is_numeric(int column) const;
    //! NaN where it is missing. \throws InputError with file, line and column where the cell holds no number.
    double number(int row, int column) const;
    //! The whole column [rows]. \throws InputError
    std::vector<double> numbers(int column) const;

  private:
    struct Row
    {
        int line;
        std::vector<std::string> cells;
    };

    void take_names(Row header);
    void add(Row row);
    void drop_empty_columns();
    void find_decimal_mark();

    std::string origin_;
    char separator_ = ',';
    int header_line_ = 0;
    std::vector<std::string> names_;
    std::vector<Row> rows_;
    DecimalMark mark_ = DecimalMark::point;
    std::string doubt_; //!< why numbers with a comma or a point cannot be read; empty: they can
};

//! A text as a cell in quotes, with those inside doubled.
std::string csv_quoted(std::string const& text);

} // namespace demens::text
