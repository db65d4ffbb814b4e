#include "report/handover/folder.hpp"

#include "demens/base/error.hpp"
#include "demens/base/file_error.hpp"
#include "demens/base/text/csv.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace demens::report {

namespace fs = std::filesystem;

Folder::Folder(fs::path folder) : folder_(std::move(folder))
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (!fs::is_directory(folder_))
        throw InputError(
            fmt::format("{} is no folder and cannot be made one ({})", folder_.string(), error.message()));
}

void Folder::write(std::string const& name, std::string const& text)
{
    auto const file = folder_ / name;
    std::error_code ignored; // the file itself says what is wrong
    fs::create_directories(file.parent_path(), ignored);
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out)
        throw FileError(fmt::format(
            "{} cannot be written; give a folder that is writable and has room for it", file.string()));
    files_.push_back(file);
}

std::string cell(std::string const& text)
{
    return text.find_first_of(",\"\n") == std::string::npos ? text : text::csv_quoted(text);
}

std::string cell(double value)
{
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string csv_line(std::vector<std::string> const& cells)
{
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (k > 0)
            line += ',';
        line += cell(cells[k]);
    }
    line += '\n';
    return line;
}

} // namespace demens::report
