#include "src/grain/point_table.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/csv.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::grain {

PointTable read_points(std::string const& text, std::string const& origin,
                       std::vector<std::string> const& names, double scale)
{
    auto const table = text::CsvTable::from_text(text, origin, names);
    if (table.rows() == 0)
        throw InputError(
            fmt::format("{}: holds no numbers; lines of {} are expected", origin, fmt::join(names, ", ")));
    std::vector<int> columns;
    for (auto const& name : names) {
        auto const other = name == "r" ? table.find("radius") : std::nullopt;
        columns.push_back(other ? *other : table.column(name));
    }
    PointTable result;
    for (int row = 0; row < table.rows(); ++row) {
        std::vector<double>& numbers = result.rows.emplace_back();
        for (int const column : columns) {
            numbers.push_back(scale * table.number(row, column));
            if (std::isnan(numbers.back()))
                throw InputError(fmt::format("{}: the column {} is empty; {} are needed", table.where(row),
                                             table.names()[static_cast<std::size_t>(column)],
                                             fmt::join(names, ", ")));
        }
        result.where.push_back(table.where(row));
    }
    return result;
}

} // namespace demens::grain
