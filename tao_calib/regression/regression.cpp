#include "tao_calib/regression/regression.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

//! Share of a column that earlier columns do not explain, below which it is theirs.
constexpr double dependent = 1e-9;

//! Whether no column comes near a combination of others.
bool clearly_independent(MatrixXd const& matrix)
{
    if (matrix.rows() < matrix.cols() || (matrix.colwise().norm().array() == 0).any())
        return false;
    Eigen::ColPivHouseholderQR<MatrixXd> const qr(matrix.colwise().normalized());
    return qr.matrixR().diagonal().cwiseAbs().minCoeff() > 1e3 * dependent;
}

void check(RegressionData const& data, std::vector<Term> const& terms)
{
    auto const runs = data.values.size();
    if (data.coded.rows() != runs || data.coded.cols() != static_cast<Index>(data.factors.size()))
        throw InputError(fmt::format("response `{}`: {} values for {} runs of {} factors, {} of them named",
                                     data.response, runs, data.coded.rows(), data.coded.cols(),
                                     data.factors.size()));
    for (Index i = 0; i < runs; ++i)
        if (!std::isfinite(data.values[i]) || !data.coded.row(i).allFinite())
            throw InputError(fmt::format("response `{}`: run {} has a number missing: leave the run out",
                                         data.response, i + 1));
    if (runs < static_cast<Index>(terms.size()))
        throw InputError(
            fmt::format("response `{}`: {} runs cannot determine {} coefficients: add runs or take a "
                        "smaller model",
                        data.response, runs, terms.size()));
    if (data.values.maxCoeff() - data.values.minCoeff() <= 1e-12 * data.values.cwiseAbs().maxCoeff())
        throw InputError(fmt::format("response `{}` is {} in all {} runs: there is nothing to fit",
                                     data.response, data.values[0], runs));
    if (data.weights.size() > 0 &&
        (data.weights.size() != runs || !(data.weights.array() > 0).all() || !data.weights.allFinite()))
        throw InputError(
            fmt::format("response `{}`: each of the {} runs needs a weight above 0", data.response, runs));
    if (auto const aliases = aliased_terms(data, terms); !aliases.empty())
        throw InputError(
            fmt::format("response `{}`: the runs cannot tell these terms apart: {}; leave terms out or "
                        "add runs",
                        data.response, fmt::join(aliases, "; ")));
}

} // namespace

std::vector<std::string> aliased_terms(RegressionData const& data, std::vector<Term> const& terms)
{
    MatrixXd const matrix = model_matrix(terms, data.coded);
    if (clearly_independent(matrix))
        return {};
    MatrixXd independent(matrix.rows(), 0), basis(matrix.rows(), 0); // the same space, of orthogonal columns
    std::vector<std::string> names, aliases;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        VectorXd const column = matrix.col(static_cast<Index>(t));
        std::string const name = terms[t].name(data.factors);
        VectorXd rest = column;
        for (int twice = 0; twice < 2; ++twice) // rounding of the first time
            rest -= basis * (basis.transpose() * rest);
        if (rest.norm() > dependent * column.norm()) {
            for (auto* to : {&independent, &basis})
                to->conservativeResize(Eigen::NoChange, to->cols() + 1);
            independent.rightCols(1) = column;
            basis.rightCols(1) = rest.normalized();
            names.push_back(name);
            continue;
        }
        VectorXd const combination = independent.cols() > 0
                                         ? VectorXd(independent.colPivHouseholderQr().solve(column))
                                         : VectorXd::Zero(0);
        std::string text;
        for (Index i = 0; i < combination.size(); ++i) {
            double const share = combination[i];
            if (std::abs(share) < 1e-6)
                continue;
            text += text.empty() ? (share < 0 ? "-" : "") : (share < 0 ? " - " : " + ");
            if (std::abs(std::abs(share) - 1) > 1e-6)
                text += fmt::format("{:.4g} ", std::abs(share));
            text += names[i];
        }
        aliases.push_back(name + " = " + (text.empty() ? "0" : text));
    }
    return aliases;
}

Regression::Regression(RegressionData data, std::vector<Term> terms) : data_(std::move(data))
{
    check(data_, terms);
    MatrixXd const matrix = model_matrix(terms, data_.coded);
    bool const weighted = data_.weights.size() > 0;
    VectorXd const root =
        weighted ? VectorXd(data_.weights.cwiseSqrt()) : VectorXd::Ones(data_.values.size());
    MatrixXd const rows = root.asDiagonal() * matrix;
    VectorXd const scale = rows.colwise().norm();
    Eigen::ColPivHouseholderQR<MatrixXd> const qr(rows * scale.cwiseInverse().asDiagonal());
    VectorXd const solution =
        scale.cwiseInverse().asDiagonal() * VectorXd(qr.solve(VectorXd(root.cwiseProduct(data_.values))));
    auto const size = matrix.cols();
    MatrixXd const inverse = qr.matrixR()
                                 .topLeftCorner(size, size)
                                 .triangularView<Eigen::Upper>()
                                 .solve(MatrixXd::Identity(size, size));
    inverse_root_ = scale.cwiseInverse().asDiagonal() * MatrixXd(qr.colsPermutation() * inverse);
    fitted_ = matrix * solution;
    leverages_ = (rows * inverse_root_).rowwise().squaredNorm();

    constexpr double roundings = 100 * std::numeric_limits<double>::epsilon();
    rounding_ = (rows.cwiseAbs() * solution.cwiseAbs()).squaredNorm() * roundings * roundings;
    for (std::size_t t = 0; t < terms.size(); ++t)
        coefficients_.push_back(
            {std::move(terms[t]), solution[static_cast<Index>(t)], not_a_number, not_a_number, not_a_number});
    if (residual_degrees_of_freedom() < 1)
        scatter_ = Scatter::saturated;
    else if (residual_sum_of_squares() <= rounding_)
        scatter_ = Scatter::none;
    double const sigma = residual_standard_deviation();
    for (std::size_t t = 0; t < coefficients_.size(); ++t) {
        auto& coefficient = coefficients_[t];
        coefficient.standard_error = sigma * inverse_root_.row(static_cast<Index>(t)).norm();
        if (scatter_ != Scatter::known)
            continue;
        coefficient.t = coefficient.value / coefficient.standard_error;
        coefficient.p = student_t_p_value(coefficient.t, residual_degrees_of_freedom());
    }
}

std::vector<Term> Regression::terms() const
{
    std::vector<Term> result;
    for (auto const& coefficient : coefficients_)
        result.push_back(coefficient.term);
    return result;
}

double Regression::weighted_mean(VectorXd const& numbers) const
{
    return data_.weights.size() == 0 ? numbers.mean() : data_.weights.dot(numbers) / data_.weights.sum();
}

double Regression::weighted_squares(Eigen::ArrayXd const& deviations) const
{
    if (data_.weights.size() == 0)
        return deviations.square().sum();
    return (data_.weights.array() * deviations.square()).sum();
}

double Regression::residual_sum_of_squares() const
{
    return weighted_squares(residuals().array());
}

double Regression::total_sum_of_squares() const
{
    return weighted_squares(data_.values.array() - weighted_mean(data_.values));
}

double Regression::residual_standard_deviation() const
{
    int const degrees = residual_degrees_of_freedom();
    return degrees < 1 ? not_a_number : std::sqrt(residual_sum_of_squares() / degrees);
}

double Regression::r_squared() const
{
    return 1 - residual_sum_of_squares() / total_sum_of_squares();
}

double Regression::adjusted_r_squared() const
{
    int const degrees = residual_degrees_of_freedom();
    if (degrees < 1)
        return not_a_number;
    return 1 - (residual_sum_of_squares() / degrees) / (total_sum_of_squares() / (runs() - 1));
}

std::optional<int> Regression::run_of_leverage_one() const
{
    Index run = 0;
    if (leverages_.maxCoeff(&run) > 1 - 1e-9)
        return static_cast<int>(run);
    return std::nullopt;
}

double Regression::prediction_sum_of_squares() const
{
    if (run_of_leverage_one())
        return not_a_number;
    return weighted_squares(residuals().array() / (1 - leverages_.array()));
}

VectorXd Regression::row(VectorXd const& coded) const
{
    VectorXd result(static_cast<Index>(coefficients_.size()));
    for (std::size_t t = 0; t < coefficients_.size(); ++t)
        result[static_cast<Index>(t)] = coefficients_[t].term.value(coded);
    return result;
}

double Regression::predict(VectorXd const& coded) const
{
    double sum = 0;
    for (auto const& coefficient : coefficients_)
        sum += coefficient.value * coefficient.term.value(coded);
    return sum;
}

double Regression::prediction_standard_error(VectorXd const& coded) const
{
    return residual_standard_deviation() * (inverse_root_.transpose() * row(coded)).norm();
}

VectorXd Regression::gradient(VectorXd const& coded) const
{
    VectorXd slope = VectorXd::Zero(coded.size());
    for (auto const& coefficient : coefficients_)
        for (Index k = 0; k < coded.size(); ++k) {
            Term lower = coefficient.term;
            int const power = lower.exponents[k]--;
            if (power > 0)
                slope[k] += coefficient.value * power * lower.value(coded);
        }
    return slope;
}

} // namespace demens::tao_calib
