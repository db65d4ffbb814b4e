#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace demens::tao_calib {

//! Numbers in named columns, read from a file of comma-separated values: one line of names, then one row a
//! line; lines that begin with # are comments, empty fields and NA or NaN are missing numbers.
class CsvTable
{
  public:
    //! \throws InputError with file and line where a row does not fit the names or holds no number.
    static CsvTable from_file(std::filesystem::path const& file);
    //! The same from text; `origin` stands for the file in messages.
    static CsvTable from_text(std::string const& text, std::string const& origin);

    std::string const& origin() const { return origin_; }
    std::vector<std::string> const& names() const { return names_; }
    int rows() const { return static_cast<int>(lines_.size()); }
    int line_of_row(int row) const { return lines_[row]; } //!< counted from 1
    //! Values of a column, NaN where missing [rows]. \throws InputError that names the columns there are.
    Eigen::VectorXd column(std::string const& name) const;

  private:
    std::string origin_;
    std::vector<std::string> names_;
    std::vector<std::vector<double>> columns_;
    std::vector<int> lines_;
};

} // namespace demens::tao_calib
