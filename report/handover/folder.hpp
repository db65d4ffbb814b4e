#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace demens::report {

//! Writes files below a folder and remembers which.
class Folder
{
  public:
    //! \throws InputError where it is no folder and cannot be made one
    explicit Folder(std::filesystem::path folder);
    //! \throws FileError
    void write(std::string const& name, std::string const& text);
    std::vector<std::filesystem::path> const& files() const { return files_; }

  private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> files_;
};

//! Text as a cell of a CSV file: in quotes where a reader could take it apart.
std::string cell(std::string const& text);
//! All digits; empty where there is no number.
std::string cell(double value);
//! Cells as a line.
std::string csv_line(std::vector<std::string> const& cells);

} // namespace demens::report
