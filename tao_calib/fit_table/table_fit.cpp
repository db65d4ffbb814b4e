#include "tao_calib/fit_table/table_fit.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::VectorXd;

TableFit::TableFit(FitInput input, text::CsvTable const& table) : input_(std::move(input))
{
    complete_bounds(table);
    make_spaces();
    fit(table, usable_rows(table));
}

void TableFit::complete_bounds(text::CsvTable const& table)
{
    for (auto& factor : input_.factors) {
        VectorXd const values = column_values(table, factor.column);
        double smallest = INFINITY, largest = -INFINITY;
        for (double value : values)
            if (!std::isnan(value)) {
                smallest = std::min(smallest, value);
                largest = std::max(largest, value);
            }
        if (std::isnan(factor.lower))
            factor.lower = smallest;
        if (std::isnan(factor.upper))
            factor.upper = largest;
        if (!(smallest < largest))
            throw InputError(fmt::format("{}: factor `{}` does not vary: its effect cannot be found",
                                         table.origin(), factor.column));
        if (!std::isnan(factor.fixed) && !(factor.fixed >= factor.lower && factor.fixed <= factor.upper))
            throw InputError(fmt::format("{}: factor `{}`: fixed = {} is outside {} to {}", input_.origin,
                                         factor.column, factor.fixed, factor.lower, factor.upper));
    }
}

void TableFit::make_spaces()
{
    std::vector<ensemble::Factor> all, free;
    for (auto const& factor : input_.factors) {
        all.push_back({factor.column, factor.column, factor.lower, factor.upper, factor.log_scale});
        if (std::isnan(factor.fixed))
            free.push_back(all.back());
    }
    if (free.empty())
        throw InputError(fmt::format("{}: every factor is fixed; leave at least one free", input_.origin));
    space_.emplace(all, std::vector<ensemble::LinearConstraint>{});

    std::vector<ensemble::LinearConstraint> left;
    for (auto const& constraint : input_.constraints) {
        left.push_back({constraint.text, {}, constraint.bound});
        for (std::size_t k = 0; k < all.size(); ++k) {
            double const fixed = input_.factors[k].fixed;
            if (std::isnan(fixed))
                left.back().coefficients.push_back(constraint.coefficients[k]);
            else
                left.back().bound -= constraint.coefficients[k] * fixed;
        }
    }
    free_space_.emplace(free, left);
}

//! Rows that have all factors and are not a copy of an earlier row.
std::vector<int> TableFit::usable_rows(text::CsvTable const& table)
{
    std::vector<VectorXd> columns;
    for (auto const& factor : input_.factors)
        columns.push_back(column_values(table, factor.column));
    for (auto const& response : input_.responses)
        columns.push_back(column_values(table, response.column));

    auto same = [&](int a, int b) {
        return std::all_of(columns.begin(), columns.end(), [&](VectorXd const& column) {
            return column[a] == column[b] || (std::isnan(column[a]) && std::isnan(column[b]));
        });
    };
    std::vector<int> rows;
    for (int row = 0; row < table.rows(); ++row) {
        auto const missing =
            std::find_if(columns.begin(), columns.begin() + static_cast<int>(input_.factors.size()),
                         [&](VectorXd const& column) { return std::isnan(column[row]); });
        if (missing != columns.begin() + static_cast<int>(input_.factors.size())) {
            warnings_.push_back(fmt::format("{}:{}: left out, since `{}` is missing", table.origin(),
                                            table.line_of_row(row),
                                            input_.factors[missing - columns.begin()].column));
            continue;
        }
        auto const copy =
            std::find_if(rows.begin(), rows.end(), [&](int earlier) { return same(earlier, row); });
        if (copy != rows.end()) {
            warnings_.push_back(
                fmt::format("{}:{}: left out, since it repeats line {} in every number: a run that was "
                            "repeated would scatter",
                            table.origin(), table.line_of_row(row), table.line_of_row(*copy)));
            continue;
        }
        rows.push_back(row);
    }
    return rows;
}

void TableFit::fit(text::CsvTable const& table, std::vector<int> const& rows)
{
    auto const factors = space_->size();
    RegressionData all;
    Eigen::MatrixXd own(static_cast<Index>(rows.size()), factors);
    for (int k = 0; k < factors; ++k) {
        all.factors.push_back(input_.factors[k].column);
        own.col(k) = column_values(table, input_.factors[k].column)(rows);
        if (input_.factors[k].log_scale && !(own.col(k).minCoeff() > 0))
            throw InputError(fmt::format("{}: factor `{}` has values that have no logarithm", table.origin(),
                                         input_.factors[k].column));
    }
    all.coded.resize(own.rows(), factors);
    for (Index i = 0; i < own.rows(); ++i)
        all.coded.row(i) = space_->coded(own.row(i).transpose()).transpose();

    auto const terms = polynomial_terms(input_.model, factors);
    for (auto& response : input_.responses) {
        VectorXd const values = column_values(table, response.column)(rows);
        std::vector<int> present, missing_lines;
        for (Index i = 0; i < values.size(); ++i) {
            if (std::isnan(values[i]))
                missing_lines.push_back(table.line_of_row(rows[i]));
            else
                present.push_back(static_cast<int>(i));
        }
        if (!missing_lines.empty())
            warnings_.push_back(fmt::format(
                "{}: `{}` is missing in line{} {}; fitted without", table.origin(), response.column,
                missing_lines.size() > 1 ? "s" : "", fmt::join(missing_lines, ", ")));
        RegressionData const data{all.factors, response.column, all.coded(present, Eigen::all),
                                  values(present)};
        fits_.push_back(input_.eliminate ? eliminate_backward(data, terms, input_.elimination)
                                         : ReducedRegression{Regression(data, terms), {}});
        warn_of_target_out_of_reach(response, data.values);
        if (std::isnan(response.scale))
            response.scale = !std::isnan(response.tolerance)
                                 ? response.tolerance
                                 : fits_.back().regression.residual_standard_deviation();
    }
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

VectorXd TableFit::all_values(VectorXd const& free_values) const
{
    VectorXd values(space_->size());
    Index next = 0;
    for (int k = 0; k < space_->size(); ++k)
        values[k] = std::isnan(input_.factors[k].fixed) ? free_values[next++] : input_.factors[k].fixed;
    return values;
}

VectorXd TableFit::predict(VectorXd const& free_values) const
{
    VectorXd const coded = space_->coded(all_values(free_values));
    VectorXd responses(static_cast<Index>(fits_.size()));
    for (std::size_t r = 0; r < fits_.size(); ++r)
        responses[static_cast<Index>(r)] = fits_[r].regression.predict(coded);
    return responses;
}

} // namespace demens::tao_calib
