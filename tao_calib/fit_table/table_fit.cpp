#include "tao_calib/fit_table/table_fit.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/regression/table_column.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <set>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::VectorXd;

//! Rows of the table that have all factors and a weight, and where the columns are.
struct TableFit::Rows
{
    std::vector<int> rows;
    std::vector<int> factors, responses; //!< columns of the table
    VectorXd weights;                    //!< of the rows; empty: all alike
};

TableFit::TableFit(FitInput input, text::CsvTable const& table) : input_(std::move(input))
{
    if (table.rows() == 0)
        throw InputError(fmt::format(
            "{}: holds no rows; a line of column names and rows of numbers are needed", table.origin()));
    auto rows = usable_rows(table);
    warn_of_repeated(table, rows);
    complete_factors(table, rows);
    try {
        space_.emplace(input_);
        fit(table, rows);
    } catch (InputError const& error) { // of layers that do not know the file
        std::string const what = error.what();
        throw InputError(what.starts_with(input_.origin) || what.starts_with(table.origin())
                             ? what
                             : fmt::format("{}: {}", input_.origin, what));
    }
}

TableFit::Rows TableFit::usable_rows(text::CsvTable const& table)
{
    Rows found;
    auto const column_of = [&](auto const& asked) {
        try {
            return table.column(asked.column);
        } catch (InputError const& error) {
            throw InputError(asked.place + error.what());
        }
    };
    for (auto& factor : input_.factors) {
        found.factors.push_back(column_of(factor));
        int const column = found.factors.back();
        bool const any_number = [&] {
            for (int row = 0; row < table.rows(); ++row)
                if (!table.is_missing(row, column) && text::number_of(table.cell(row, column)))
                    return true;
            return false;
        }();
        // Words throughout: levels. A word among numbers is a slip, which reading the numbers will name.
        if (factor.kind == FactorKind::continuous && !table.is_numeric(column) && !any_number)
            factor.kind = FactorKind::categorical;
        if (factor.kind != FactorKind::continuous && (factor.log_scale || !std::isnan(factor.lower) ||
                                                      !std::isnan(factor.upper) || !std::isnan(factor.fixed)))
            throw InputError(
                fmt::format("{}: factor `{}` is categorical: lower, upper, log_scale and fixed mean "
                            "nothing; fixed_level does",
                            input_.origin, factor.column));
        if (factor.kind == FactorKind::continuous && !factor.fixed_level.empty())
            throw InputError(fmt::format("{}: factor `{}` holds numbers: give fixed in place of fixed_level",
                                         input_.origin, factor.column));
        if (factor.kind == FactorKind::continuous)
            (void)table.numbers(column);
    }
    for (auto const& response : input_.responses) {
        found.responses.push_back(column_of(response));
        (void)table.numbers(found.responses.back());
    }
    VectorXd const weights = input_.weights.empty() ? VectorXd() : column_values(table, input_.weights);
    std::vector<double> kept_weights;
    for (int row = 0; row < table.rows(); ++row) {
        auto const leave_out = [&](std::string const& why) {
            warnings_.push_back(fmt::format("{}: left out, since {}", table.where(row), why));
        };
        auto const missing = std::find_if(found.factors.begin(), found.factors.end(),
                                          [&](int column) { return table.is_missing(row, column); });
        if (missing != found.factors.end()) {
            leave_out(fmt::format(
                "`{}` is missing",
                input_.factors[static_cast<std::size_t>(missing - found.factors.begin())].column));
            continue;
        }
        if (weights.size() > 0) {
            if (weights[row] < 0)
                throw InputError(fmt::format("{}: the weight `{}` = {} must be above 0", table.where(row),
                                             input_.weights, weights[row]));
            if (!(weights[row] > 0)) {
                leave_out(fmt::format("its weight `{}` is {}", input_.weights,
                                      std::isnan(weights[row]) ? "missing" : "0"));
                continue;
            }
            kept_weights.push_back(weights[row]);
        }
        found.rows.push_back(row);
    }
    found.weights = VectorXd::Map(kept_weights.data(), static_cast<Index>(kept_weights.size()));
    return found;
}

//! Rows that are an earlier one in every cell that is used: repeated runs scatter, copies do not.
void TableFit::warn_of_repeated(text::CsvTable const& table, Rows& rows)
{
    auto columns = rows.factors;
    columns.insert(columns.end(), rows.responses.begin(), rows.responses.end());
    std::map<std::vector<std::string>, int> first;
    std::vector<std::size_t> copies;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        int const row = rows.rows[i];
        std::vector<std::string> cells;
        for (int const column : columns)
            cells.push_back(table.is_numeric(column) ? fmt::format("{}", table.number(row, column))
                                                     : table.cell(row, column));
        auto const [place, is_new] = first.try_emplace(cells, row);
        if (is_new)
            continue;
        copies.push_back(i);
        warnings_.push_back(fmt::format(
            "{}: repeats line {} in every number{}", table.where(row), table.line_of_row(place->second),
            input_.keep_repeated
                ? "; it is kept, as a run of its own. If it is a copy: repeated_rows = \"leave_out\""
                : ": left out"));
    }
    if (input_.keep_repeated)
        return;
    for (auto copy = copies.rbegin(); copy != copies.rend(); ++copy) {
        auto const i = static_cast<std::ptrdiff_t>(*copy);
        rows.rows.erase(rows.rows.begin() + i);
        if (rows.weights.size() > 0) {
            auto const after = rows.weights.size() - i - 1;
            rows.weights.segment(i, after) = VectorXd(rows.weights.tail(after));
            rows.weights.conservativeResize(rows.weights.size() - 1);
        }
    }
}

//! Bounds and levels as the table has them.
void TableFit::complete_factors(text::CsvTable const& table, Rows const& rows)
{
    for (std::size_t k = 0; k < input_.factors.size(); ++k) {
        auto& factor = input_.factors[k];
        int const column = rows.factors[k];
        auto const constant = [&] {
            throw InputError(fmt::format("{}: factor `{}` does not vary: its effect cannot be found",
                                         table.origin(), factor.column));
        };
        if (factor.kind != FactorKind::continuous) {
            for (int const row : rows.rows)
                if (auto const& level = table.cell(row, column);
                    std::find(factor.levels.begin(), factor.levels.end(), level) == factor.levels.end())
                    factor.levels.push_back(level);
            if (factor.levels.size() < 2)
                constant();
            if (table.is_numeric(column))
                std::sort(factor.levels.begin(), factor.levels.end(), [](auto const& a, auto const& b) {
                    return text::number_of(a) < text::number_of(b);
                });
            continue;
        }
        std::set<double> values;
        for (int const row : rows.rows)
            values.insert(table.number(row, column));
        if (values.size() < 2)
            constant();
        if (values.size() == 2)
            factor.levels = {fmt::format("{}", *values.begin()), fmt::format("{}", *values.rbegin())};
        if (factor.log_scale && !(*values.begin() > 0))
            throw InputError(fmt::format("{}: factor `{}` has values that have no logarithm", table.origin(),
                                         factor.column));
        if (std::isnan(factor.lower))
            factor.lower = *values.begin();
        if (std::isnan(factor.upper))
            factor.upper = *values.rbegin();
        if (!(factor.lower < factor.upper))
            throw InputError(
                fmt::format("{}: factor `{}`: lower = {} is not below upper = {}; one of them is that of "
                            "the table",
                            input_.origin, factor.column, factor.lower, factor.upper));
        if (*values.rbegin() < factor.lower || *values.begin() > factor.upper)
            throw InputError(fmt::format("{}none of its values in {}, {} to {}, is between lower = {} and "
                                         "upper = {}; give bounds in the "
                                         "unit of the table, or leave them out",
                                         factor.place, table.origin(), *values.begin(), *values.rbegin(),
                                         factor.lower, factor.upper));
        if (!std::isnan(factor.fixed) && !(factor.fixed >= factor.lower && factor.fixed <= factor.upper))
            throw InputError(fmt::format("{}: factor `{}`: fixed = {} is outside {} to {}", input_.origin,
                                         factor.column, factor.fixed, factor.lower, factor.upper));
    }
}

//! [rows x columns]
Eigen::MatrixXd TableFit::coded(text::CsvTable const& table, Rows const& rows) const
{
    Eigen::MatrixXd result(static_cast<Index>(rows.rows.size()), static_cast<Index>(space_->names().size()));
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        VectorXd values(static_cast<Index>(input_.factors.size()));
        for (std::size_t k = 0; k < input_.factors.size(); ++k) {
            auto const& levels = input_.factors[k].levels;
            values[static_cast<Index>(k)] =
                input_.factors[k].kind == FactorKind::continuous
                    ? table.number(rows.rows[i], rows.factors[k])
                    : static_cast<double>(
                          std::find(levels.begin(), levels.end(), table.cell(rows.rows[i], rows.factors[k])) -
                          levels.begin());
        }
        result.row(static_cast<Index>(i)) = space_->coded(values).transpose();
    }
    return result;
}

void TableFit::fit(text::CsvTable const& table, Rows const& rows)
{
    auto const all = coded(table, rows);
    auto const terms = terms_of(input_, *space_);
    constexpr std::size_t most_terms = 600; // elimination costs a third power of them
    if (terms.size() > most_terms)
        throw InputError(
            fmt::format("{}: {} factors make a model of {} terms, of which {} can be dealt with: take "
                        "model = \"linear\" or \"interaction\", or leave_out",
                        input_.origin, input_.factors.size(), terms.size(), most_terms));
    for (std::size_t k = 0; k < input_.factors.size(); ++k)
        if (input_.factors[k].kind == FactorKind::block)
            input_.elimination.always.push_back(static_cast<int>(k));
    std::vector<std::string> failures;
    for (std::size_t r = 0; r < input_.responses.size(); ++r) {
        auto const& response = input_.responses[r];
        std::vector<int> present, lines, missing_lines;
        std::vector<double> values;
        for (std::size_t i = 0; i < rows.rows.size(); ++i) {
            double const value = table.number(rows.rows[i], rows.responses[r]);
            int const line = table.line_of_row(rows.rows[i]);
            if (std::isnan(value)) {
                missing_lines.push_back(line);
                continue;
            }
            present.push_back(static_cast<int>(i));
            lines.push_back(line);
            values.push_back(value);
        }
        if (!missing_lines.empty())
            warnings_.push_back(fmt::format(
                "{}: `{}` is missing in line{} {}; fitted without", table.origin(), response.column,
                missing_lines.size() > 1 ? "s" : "", fmt::join(missing_lines, ", ")));
        RegressionData data{space_->names(),
                            response.column,
                            all(present, Eigen::all),
                            VectorXd::Map(values.data(), static_cast<Index>(values.size())),
                            {},
                            space_->factor_of()};
        if (rows.weights.size() > 0)
            data.weights = rows.weights(present);
        fits_.push_back(fit_response(data, terms));
        fits_.back().lines = std::move(lines);
        if (fits_.back().reduced) {
            warn_of_fit(fits_.back());
            warn_of_target_out_of_reach(response, data.values);
        } else {
            failures.push_back(fits_.back().failure);
        }
    }
    if (failures.size() == fits_.size())
        throw InputError(fmt::format("{}", fmt::join(failures, "\n")));
    for (auto const& failure : failures)
        warnings_.push_back(failure + "; this response is not fitted");
    complete_scales();
}

ResponseFit TableFit::fit_response(RegressionData const& data, std::vector<Term> const& terms) const
{
    try {
        if (data.values.size() == 0)
            throw InputError(fmt::format("response `{}` has no values", data.response));
        if (input_.eliminate)
            return {eliminate_backward(data, terms, input_.elimination), {}, {}};
        return {ReducedRegression{Regression(data, terms), {}}, {}, {}};
    } catch (InputError const& error) {
        return {std::nullopt, error.what(), {}};
    }
}

void TableFit::warn_of_fit(ResponseFit const& fit)
{
    auto const& regression = fit.regression();
    auto const& name = regression.data().response;
    if (regression.scatter() == Scatter::saturated)
        warnings_.push_back(fmt::format(
            "`{}`: {} runs for {} coefficients leave no degree of freedom: errors, tests, intervals, "
            "adjusted and predicted R2 are not defined",
            name, regression.runs(), regression.coefficients().size()));
    else if (regression.scatter() == Scatter::none)
        warnings_.push_back(
            fmt::format("`{}`: the model meets every run but for rounding: there is no scatter to test "
                        "against, and errors and intervals mean nothing",
                        name));
    if (auto const run = regression.run_of_leverage_one(); run && regression.scatter() != Scatter::saturated)
        warnings_.push_back(
            fmt::format("`{}`: the run in line {} alone determines a coefficient (leverage 1): "
                        "predicted R2 is not defined",
                        name, fit.lines.at(static_cast<std::size_t>(*run))));
}

void TableFit::warn_of_target_out_of_reach(FitResponse const& response, VectorXd const& values)
{
    double const smallest = values.minCoeff(), largest = values.maxCoeff();
    if (response.target > largest)
        warnings_.push_back(fmt::format("`{}`: the target {} is above every run, by {:.4g}", response.column,
                                        response.target, response.target - largest));
    if (response.target < smallest)
        warnings_.push_back(fmt::format("`{}`: the target {} is below every run, by {:.4g}", response.column,
                                        response.target, smallest - response.target));
}

//! Deviations count in tolerances, or in what scatters; where a response that would need it has no scatter,
//! in ranges, for all that have neither scale nor tolerance, so that they compare.
void TableFit::complete_scales()
{
    std::vector<std::size_t> open;
    bool scatter_known = true;
    for (std::size_t r = 0; r < fits_.size(); ++r) {
        auto& response = input_.responses[r];
        if (std::isnan(response.scale))
            response.scale = response.tolerance;
        if (!std::isnan(response.scale) || !fits_[r].reduced)
            continue;
        open.push_back(r);
        if (!std::isnan(response.target))
            scatter_known &= fits_[r].regression().scatter() == Scatter::known;
    }
    for (auto const r : open) {
        auto const& regression = fits_[r].regression();
        auto const& values = regression.data().values;
        bool const by_scatter = scatter_known && regression.scatter() == Scatter::known;
        input_.responses[r].scale =
            by_scatter ? regression.residual_standard_deviation() : values.maxCoeff() - values.minCoeff();
        if (!by_scatter && !std::isnan(input_.responses[r].target))
            warnings_.push_back(
                fmt::format("`{}`: without a known scatter, and without scale or tolerance, its "
                            "deviation is counted in the range of its runs, {:.4g}",
                            input_.responses[r].column, input_.responses[r].scale));
    }
}

bool TableFit::answers() const
{
    for (std::size_t r = 0; r < fits_.size(); ++r)
        if (!fits_[r].reduced && !std::isnan(input_.responses[r].target))
            return false;
    return true;
}

VectorXd TableFit::predict(VectorXd const& free_values) const
{
    return predict(free_values, space_->choices().front());
}

VectorXd TableFit::predict(VectorXd const& free_values, Levels const& levels) const
{
    VectorXd const coded = space_->coded(space_->all_values(free_values, levels));
    VectorXd responses(static_cast<Index>(fits_.size()));
    for (std::size_t r = 0; r < fits_.size(); ++r)
        responses[static_cast<Index>(r)] = fits_[r].reduced ? fits_[r].regression().predict(coded)
                                                            : std::numeric_limits<double>::quiet_NaN();
    return responses;
}

} // namespace demens::tao_calib
