#include "ensemble/curve/measured_curve.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "demens/base/text/csv.hpp"
#include "ensemble/curve/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace demens::ensemble {
namespace {

//! Column of a table in the unit that is wanted [rows].
std::vector<double> numbers_in(text::CsvTable const& table, std::string const& column,
                               std::string const& units)
{
    int const index = table.column(column);
    auto const given = unit_in_name(table.names()[static_cast<std::size_t>(index)]);
    double ratio = 1;
    try {
        if (given.empty() && units != "1")
            throw InputError(
                fmt::format("its name says no unit; call it {}_{} or \"{} [{}]\", with the unit it has",
                            column, "UNIT", column, units));
        ratio = given.empty() ? 1 : unit_ratio(given, units);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: column `{}`, compared with what is in {}: {}", table.origin(),
                                     column, units, error.what()));
    }
    std::vector<double> numbers;
    for (int row = 0; row < table.rows(); ++row) {
        if (table.is_missing(row, index))
            throw InputError(fmt::format("{}: column `{}` has no value: the curve has a gap; leave the line "
                                         "out if the curve may go straight on over it",
                                         table.where(row), column));
        numbers.push_back(ratio * table.number(row, index));
    }
    return numbers;
}

//! What is left of values beside the parabola through them.
std::vector<double> beside_parabola(std::span<double const> axis, std::span<double const> values)
{
    // Gram-Schmidt on 1, x, x^2 with x in [-1, 1].
    std::size_t const n = axis.size();
    double const middle = 0.5 * (axis.front() + axis.back()), half = 0.5 * (axis.back() - axis.front());
    std::vector<std::vector<double>> basis;
    std::vector<double> rest(values.begin(), values.end());
    for (int power = 0; power < 3; ++power) {
        std::vector<double> column(n);
        for (std::size_t k = 0; k < n; ++k)
            column[k] = std::pow((axis[k] - middle) / half, power);
        auto const project_out = [n](std::vector<double>& from, std::vector<double> const& unit) {
            double dot = 0;
            for (std::size_t k = 0; k < n; ++k)
                dot += from[k] * unit[k];
            for (std::size_t k = 0; k < n; ++k)
                from[k] -= dot * unit[k];
        };
        for (auto const& unit : basis)
            project_out(column, unit);
        double square = 0;
        for (double const c : column)
            square += c * c;
        for (double& c : column)
            c /= std::sqrt(square);
        project_out(rest, column);
        basis.push_back(std::move(column));
    }
    return rest;
}

} // namespace

std::vector<double> MeasuredCurve::shares() const
{
    std::size_t const n = size();
    if (n < 2)
        return std::vector<double>(n, 1.0);
    std::vector<double> shares(n);
    double const length = axis.back() - axis.front();
    for (std::size_t k = 0; k < n; ++k)
        shares[k] = 0.5 * (axis[std::min(k + 1, n - 1)] - axis[k > 0 ? k - 1 : 0]) / length;
    return shares;
}

double MeasuredCurve::at(double place) const
{
    if (axis.empty() || !(place >= axis.front() && place <= axis.back()))
        return not_a_number;
    auto const next = std::upper_bound(axis.begin(), axis.end(), place);
    if (next == axis.end())
        return values.back();
    auto const k = static_cast<std::size_t>(next - axis.begin());
    double const t = (place - axis[k - 1]) / (axis[k] - axis[k - 1]);
    return (1 - t) * values[k - 1] + t * values[k];
}

MeasuredCurve read_curve(std::string const& csv, std::string const& origin, CurveColumns const& columns)
{
    auto const table = text::CsvTable::from_text(csv, origin);
    MeasuredCurve curve{numbers_in(table, columns.axis, columns.axis_units),
                        numbers_in(table, columns.value, columns.value_units)};
    if (curve.size() < 2)
        throw InputError(
            fmt::format("{}: has {} rows; a curve needs two points at least", origin, curve.size()));
    for (int row = 1; row < table.rows(); ++row)
        if (auto const k = static_cast<std::size_t>(row); !(curve.axis[k] > curve.axis[k - 1]))
            throw InputError(fmt::format("{}: column `{}` must ascend, but {} comes after {}",
                                         table.where(row), columns.axis,
                                         table.cell(row, table.column(columns.axis)),
                                         table.cell(row - 1, table.column(columns.axis))));
    return curve;
}

CurveScatter scatter_of(MeasuredCurve const& curve)
{
    constexpr std::size_t least_in_piece = 12, most_pieces = 8, parameters = 3;
    std::size_t const n = curve.size(), pieces = std::min(most_pieces, n / least_in_piece);
    if (pieces == 0)
        return {not_a_number, static_cast<double>(n)};
    double squares = 0, products = 0;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        std::size_t const from = piece * n / pieces, to = (piece + 1) * n / pieces;
        auto const rest = beside_parabola(std::span(curve.axis).subspan(from, to - from),
                                          std::span(curve.values).subspan(from, to - from));
        for (std::size_t k = 0; k < rest.size(); ++k) {
            squares += rest[k] * rest[k];
            products += k > 0 ? rest[k] * rest[k - 1] : 0.0;
        }
    }
    double const count = static_cast<double>(n),
                 sd = std::sqrt(squares / (count - static_cast<double>(parameters * pieces)));
    double const r = squares > 0 ? std::clamp(products / squares, 0.0, 1.0) : 0.0;
    return {sd, std::max(1.0, count * (1 - r) / (1 + r))};
}

} // namespace demens::ensemble
