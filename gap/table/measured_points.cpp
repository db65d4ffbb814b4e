#include "gap/table/measured_points.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::gap {
namespace {

using tao_calib::FactorKind;
using tao_calib::FitFactor;
using tao_calib::FitInput;
using text::CsvTable;

constexpr char const* sd_of = "_sd"; //!< after the name of a response

//! Columns of the table of measurements that mean something.
struct Columns
{
    std::vector<std::optional<int>> factors, responses, sds;
};

Columns columns_of(FitInput const& input, CsvTable const& measured)
{
    Columns columns;
    for (auto const& factor : input.factors)
        columns.factors.push_back(measured.find(factor.column));
    for (auto const& response : input.responses) {
        columns.responses.push_back(measured.find(response.column));
        columns.sds.push_back(columns.responses.back() ? measured.find(response.column + sd_of)
                                                       : std::nullopt);
    }
    auto const any = [](auto const& found) {
        return std::any_of(found.begin(), found.end(), [](auto const& column) { return column.has_value(); });
    };
    if (!any(columns.responses))
        throw InputError(fmt::format("{}: has no column of a [[response]] of {}: nothing is measured",
                                     measured.origin(), input.origin));
    if (!any(columns.factors))
        throw InputError(fmt::format("{}: has no column of a [[factor]] of {}: where was this measured?",
                                     measured.origin(), input.origin));
    if (std::all_of(columns.factors.begin(), columns.factors.end(),
                    [](auto const& column) { return column.has_value(); }))
        throw InputError(fmt::format("{}: has a column of every [[factor]] of {}: none is left to be found; "
                                     "leave out those that were not known where this was measured",
                                     measured.origin(), input.origin));
    return columns;
}

//! Columns that nothing is taken from.
void warn_of_others(std::vector<std::string>& warnings, Columns const& columns, CsvTable const& measured)
{
    for (int c = 0; c < static_cast<int>(measured.names().size()); ++c) {
        auto const is_this = [&](auto const& column) { return column == c; };
        if (std::none_of(columns.factors.begin(), columns.factors.end(), is_this) &&
            std::none_of(columns.responses.begin(), columns.responses.end(), is_this) &&
            std::none_of(columns.sds.begin(), columns.sds.end(), is_this))
            warnings.push_back(fmt::format("{}: nothing is taken from the column `{}`", measured.origin(),
                                           measured.names()[static_cast<std::size_t>(c)]));
    }
}

//! A factor that the measurements know is fixed, at first where the first of them is.
void fix_known(FitInput& input, Columns const& columns, CsvTable const& table, CsvTable const& measured)
{
    for (std::size_t k = 0; k < input.factors.size(); ++k) {
        FitFactor& factor = input.factors[k];
        if (!columns.factors[k])
            continue;
        int const column = *columns.factors[k];
        if (factor.kind == FactorKind::block)
            throw InputError(fmt::format("{}: `{}` is a block of {}, which measurements have none of",
                                         measured.origin(), factor.column, input.origin));
        if (!std::isnan(factor.fixed) || !factor.fixed_level.empty())
            throw InputError(fmt::format("{}factor `{}` is fixed, and {} says where it was: leave out one",
                                         factor.place, factor.column, measured.origin()));
        for (int row = 0; row < measured.rows(); ++row)
            if (measured.is_missing(row, column))
                throw InputError(fmt::format("{}: `{}` is missing; give it in every line, or leave the "
                                             "column out",
                                             measured.where(row), factor.column));
        int const of_runs = table.column(factor.column);
        if (factor.kind == FactorKind::categorical || !table.is_numeric(of_runs)) {
            factor.fixed_level = measured.cell(0, column);
            continue;
        }
        auto const runs = table.numbers(of_runs);
        auto const [lowest, highest] = std::minmax_element(runs.begin(), runs.end());
        for (int row = 0; row < measured.rows(); ++row)
            if (double const value = measured.number(row, column); value < *lowest || value > *highest)
                throw InputError(fmt::format(
                    "{}: `{}` = {} is beyond all runs of {}, {} to {}, where a polynomial says "
                    "nothing; leave the line out",
                    measured.where(row), factor.column, value, table.origin(), *lowest, *highest));
        factor.fixed = measured.number(0, column);
    }
}

//! Number, or place among the levels. \throws InputError
double known_value(FitFactor const& factor, CsvTable const& measured, int row, int column)
{
    if (factor.kind == FactorKind::continuous)
        return measured.number(row, column);
    auto const& level = measured.cell(row, column);
    auto const found = std::find(factor.levels.begin(), factor.levels.end(), level);
    if (found == factor.levels.end())
        throw InputError(fmt::format("{}: `{}` = {} is in no run; there are {}", measured.where(row),
                                     factor.column, level, fmt::join(factor.levels, ", ")));
    return static_cast<double>(found - factor.levels.begin());
}

MeasuredPoint point_of(FitInput const& input, Columns const& columns, CsvTable const& measured, int row)
{
    auto const responses = static_cast<Eigen::Index>(input.responses.size());
    MeasuredPoint point{{},
                        std::vector(input.factors.size(), not_a_number),
                        Eigen::VectorXd::Constant(responses, not_a_number),
                        Eigen::VectorXd::Constant(responses, not_a_number)};
    std::vector<std::string> words;
    for (std::size_t k = 0; k < input.factors.size(); ++k) {
        if (!columns.factors[k])
            continue;
        point.known[k] = known_value(input.factors[k], measured, row, *columns.factors[k]);
        words.push_back(
            fmt::format("{} {}", input.factors[k].column, measured.cell(row, *columns.factors[k])));
    }
    point.name = fmt::format("{}", fmt::join(words, ", "));
    for (std::size_t r = 0; r < input.responses.size(); ++r) {
        auto const at = static_cast<Eigen::Index>(r);
        if (columns.responses[r])
            point.values[at] = measured.number(row, *columns.responses[r]);
        if (!columns.sds[r])
            continue;
        point.sd[at] = measured.number(row, *columns.sds[r]);
        if (!(point.sd[at] > 0) && !std::isnan(point.values[at]))
            throw InputError(fmt::format("{}: `{}{}` must be above 0", measured.where(row),
                                         input.responses[r].column, sd_of));
    }
    return point;
}

} // namespace

MeasuredTable measured_table(FitInput input, CsvTable const& runs, CsvTable const& measured)
{
    if (measured.rows() < 2)
        throw InputError(fmt::format("{}: one point alone contradicts nothing: give two lines or more",
                                     measured.origin()));
    auto const columns = columns_of(input, measured);
    std::vector<std::string> warnings;
    warn_of_others(warnings, columns, measured);
    fix_known(input, columns, runs, measured);
    MeasuredTable result{tao_calib::TableFit(std::move(input), runs), {}, {}, std::move(warnings)};
    auto const& complete = result.fit.input();
    for (std::size_t k = 0; k < complete.factors.size(); ++k)
        if (columns.factors[k])
            result.conditions.push_back(static_cast<int>(k));
    for (int row = 0; row < measured.rows(); ++row)
        result.points.push_back(point_of(complete, columns, measured, row));
    return result;
}

MeasuredTable read_measured(std::filesystem::path const& file)
{
    auto input = FitInput::from_file(file);
    if (input.measured.empty())
        throw InputError(fmt::format("{}: [fit] measured: name the table of measurements: a line a point, "
                                     "with the factors that are known there and the responses",
                                     input.origin));
    auto const runs = tao_calib::table_of(input.table, input.table_place);
    auto const measured = tao_calib::table_of(input.measured, input.measured_place);
    return measured_table(std::move(input), runs, measured);
}

} // namespace demens::gap
