#include "tao_calib/regression/regression.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double dependent =
    1e-9; //!< share of a column that earlier columns do not explain, below which it is theirs

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
    MatrixXd independent(matrix.rows(), 0);
    std::vector<std::string> names, aliases;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        VectorXd const column = matrix.col(static_cast<Index>(t));
        std::string const name = terms[t].name(data.factors);
        VectorXd combination = VectorXd::Zero(independent.cols());
        if (independent.cols() > 0)
            combination = independent.colPivHouseholderQr().solve(column);
        if ((column - independent * combination).norm() > dependent * column.norm()) {
            independent.conservativeResize(Eigen::NoChange, independent.cols() + 1);
            independent.rightCols(1) = column;
            names.push_back(name);
            continue;
        }
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
    VectorXd const scale = matrix.colwise().norm();
    Eigen::ColPivHouseholderQR<MatrixXd> const qr(matrix * scale.cwiseInverse().asDiagonal());
    VectorXd const solution = scale.cwiseInverse().asDiagonal() * VectorXd(qr.solve(data_.values));
    auto const size = matrix.cols();
    MatrixXd const inverse = qr.matrixR()
                                 .topLeftCorner(size, size)
                                 .triangularView<Eigen::Upper>()
                                 .solve(MatrixXd::Identity(size, size));
    inverse_root_ = scale.cwiseInverse().asDiagonal() * MatrixXd(qr.colsPermutation() * inverse);
    fitted_ = matrix * solution;
    leverages_ = (matrix * inverse_root_).rowwise().squaredNorm();

    for (std::size_t t = 0; t < terms.size(); ++t)
        coefficients_.push_back({std::move(terms[t]), solution[static_cast<Index>(t)], 0, 0, 0});
    double const sigma = residual_standard_deviation();
    for (std::size_t t = 0; t < coefficients_.size(); ++t) {
        auto& coefficient = coefficients_[t];
        coefficient.standard_error = sigma * inverse_root_.row(static_cast<Index>(t)).norm();
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

double Regression::total_sum_of_squares() const
{
    return (data_.values.array() - data_.values.mean()).square().sum();
}

double Regression::residual_standard_deviation() const
{
    return std::sqrt(residual_sum_of_squares() / residual_degrees_of_freedom());
}

double Regression::r_squared() const
{
    return 1 - residual_sum_of_squares() / total_sum_of_squares();
}

double Regression::adjusted_r_squared() const
{
    return 1 - (residual_sum_of_squares() / residual_degrees_of_freedom()) /
                   (total_sum_of_squares() / (runs() - 1));
}

double Regression::prediction_sum_of_squares() const
{
    return (residuals().array() / (1 - leverages_.array())).square().sum();
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

namespace {

bool keeps(Term const& kept, Term const& by, Hierarchy hierarchy)
{
    bool const is_square =
        by.degree() == 2 && *std::max_element(by.exponents.begin(), by.exponents.end()) == 2;
    return !(kept == by) && kept.marginal_to(by) && (hierarchy == Hierarchy::strict || !is_square);
}

//! The least significant term that may go; nullptr when all have to stay.
Coefficient const* weakest_of(std::vector<Coefficient> const& coefficients, EliminationOptions const& options)
{
    Coefficient const* weakest = nullptr;
    for (auto const& candidate : coefficients) {
        bool const kept = std::any_of(coefficients.begin(), coefficients.end(), [&](auto const& other) {
            return keeps(candidate.term, other.term, options.hierarchy);
        });
        if (!kept && candidate.term.degree() > 0 && candidate.p > options.alpha &&
            (weakest == nullptr || candidate.p > weakest->p))
            weakest = &candidate;
    }
    return weakest;
}

} // namespace

ReducedRegression eliminate_backward(RegressionData const& data, std::vector<Term> const& terms,
                                     EliminationOptions const& options)
{
    ReducedRegression reduced{Regression(data, terms), {}};
    if (reduced.regression.residual_degrees_of_freedom() < 1)
        throw InputError(
            fmt::format("response `{}`: {} runs leave nothing to test {} coefficients against: add runs or "
                        "take a smaller model",
                        data.response, data.values.size(), terms.size()));
    while (auto const* weakest = weakest_of(reduced.regression.coefficients(), options)) {
        reduced.eliminated.push_back({weakest->term, weakest->p});
        auto kept = reduced.regression.terms();
        std::erase(kept, reduced.eliminated.back().term);
        reduced.regression = Regression(data, kept);
    }
    return reduced;
}

} // namespace demens::tao_calib
