#include "ensemble/input/design_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::ensemble::input {
namespace {

using Point = std::vector<double>;

std::vector<std::string> unused(text::CsvTable const& table, std::vector<int> const& used)
{
    std::vector<std::string> names;
    for (int column = 0; column < static_cast<int>(table.names().size()); ++column)
        if (std::find(used.begin(), used.end(), column) == used.end())
            names.push_back(fmt::format("`{}`", table.names()[static_cast<std::size_t>(column)]));
    return names;
}

std::vector<std::string> read_csv(std::string const& content, std::string const& name, CampaignInput& input)
{
    auto const table = text::CsvTable::from_text(content, name);
    auto const columns = factor_columns(table, input.factors);
    if (table.rows() == 0)
        throw InputError(name + ": holds no rows; give one row of factor values for each design point");
    for (int row = 0; row < table.rows(); ++row) {
        Point point;
        for (std::size_t f = 0; f < columns.size(); ++f) {
            if (table.is_missing(row, columns[f]))
                throw InputError(fmt::format("{}: column `{}` has no value; every design point needs one",
                                             table.where(row), input.factors[f].name));
            point.push_back(table.number(row, columns[f]));
        }
        if (auto const wrong = wrong_with_point(point, input); !wrong.empty())
            throw InputError(
                fmt::format("{}: row {} ({}){}", table.where(row), row + 1, fmt::join(point, ", "), wrong));
        input.design.table.push_back(std::move(point));
    }
    auto const left = unused(table, columns);
    if (left.empty())
        return {};
    return {fmt::format("design.table_file: {}: {} {} no factor and {} not used", name, fmt::join(left, ", "),
                        left.size() == 1 ? "names" : "name", left.size() == 1 ? "is" : "are")};
}

} // namespace

std::string wrong_with_point(Point const& point, CampaignInput const& input)
{
    if (point.size() != input.factors.size())
        return fmt::format(" has {} values; there are {} factors", point.size(), input.factors.size());
    for (std::size_t f = 0; f < point.size(); ++f) {
        auto const& factor = input.factors[f];
        if (!(point[f] >= factor.lower && point[f] <= factor.upper))
            return fmt::format(": {} = {} is outside its bounds {} and {}", factor.name, point[f],
                               factor.lower, factor.upper);
    }
    auto const broken = broken_constraint(input, point);
    return broken.empty() ? "" : fmt::format(" breaks the constraint \"{}\"", broken);
}

std::vector<int> factor_columns(text::CsvTable const& table, std::vector<Factor> const& factors)
{
    std::vector<int> columns;
    for (auto const& factor : factors) {
        auto const column = table.find(factor.path);
        columns.push_back(column ? *column : table.column(factor.name));
    }
    return columns;
}

std::string broken_constraint(CampaignInput const& input, Point const& point)
{
    for (auto const& constraint : input.constraints) {
        double sum = 0;
        for (std::size_t f = 0; f < point.size(); ++f)
            sum += constraint.coefficients[f] * point[f];
        if (sum > constraint.bound)
            return constraint.text;
    }
    return {};
}

std::vector<std::string> read_design_table(InputTable const& design, FileSource const& files,
                                           CampaignInput& input, rig::Files& kept)
{
    auto const& name = input.design.table_file;
    input.design.table = design.rows_of_numbers("table");
    for (std::size_t row = 0; row < input.design.table.size(); ++row) {
        auto const& point = input.design.table[row];
        if (auto const wrong = wrong_with_point(point, input); !wrong.empty())
            throw design.error("table", fmt::format("row {} ({}){}", row + 1, fmt::join(point, ", "), wrong));
    }
    if (name.empty())
        return {};
    if (design.has("table"))
        throw design.error("table_file", "does not go with table = [...]; give the points in one place");
    try {
        if (!kept.count(name))
            kept.emplace(name, std::make_shared<std::string const>(files(name)));
        return read_csv(*kept.at(name), name, input);
    } catch (InputError const& error) {
        throw design.error("table_file", error.what());
    }
}

} // namespace demens::ensemble::input
