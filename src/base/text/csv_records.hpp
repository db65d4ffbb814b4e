#pragma once

#include <string>
#include <vector>

namespace demens::text {

//! Cells between separators, and the line in which they begin.
struct CsvRecord
{
    int line; //!< counted from 1
    std::vector<std::string> cells;
    bool comment = false; //!< a line that begins with #, the cells of what follows it
};

//! Takes text apart into records: a line each, more where a cell in quotes goes on. Lines without any content
//! are left out.
class CsvRecords
{
  public:
    //! \param text plain, see plain_text \param separator a blank stands for any number of blanks
    CsvRecords(std::string const& text, std::string const& origin, char separator, std::size_t from = 0,
               int line = 1)
        : text_(text), origin_(origin), separator_(separator), at_(from), line_(line)
    {
    }
    //! False at the end. \throws InputError where a quote is not closed
    bool next(CsvRecord& record);

  private:
    void read(CsvRecord& record);
    std::string read_cell();
    std::string read_quoted();

    std::string const& text_;
    std::string const& origin_;
    char separator_;
    std::size_t at_;
    int line_;
};

//! Where the records begin and what separates their cells.
struct CsvDialect
{
    char separator;
    std::size_t start = 0; //!< behind a first line `sep=;`
    int line = 1;          //!< there
};
CsvDialect csv_dialect(std::string const& text, std::string const& origin);

} // namespace demens::text
