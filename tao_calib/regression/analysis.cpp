#include "tao_calib/regression/analysis.hpp"

#include "demens/base/not_a_number.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

AnovaRow untested(std::string source, double sum_of_squares, int degrees)
{
    return {std::move(source), sum_of_squares, degrees, degrees > 0 ? sum_of_squares / degrees : not_a_number,
            not_a_number,      not_a_number};
}

//! F and p stay undefined where nothing scatters or no degree of freedom tells.
AnovaRow tested(std::string source, double sum_of_squares, int degrees, AnovaRow const& error)
{
    if (degrees < 1 || !(error.mean_square > 0))
        return untested(std::move(source), sum_of_squares, degrees);
    double const mean_square = sum_of_squares / degrees, f = mean_square / error.mean_square;
    return {std::move(source),
            sum_of_squares,
            degrees,
            mean_square,
            f,
            f_p_value(f, degrees, error.degrees_of_freedom)};
}

//! Scatter of the runs about the mean of their own point.
AnovaRow pure_error(RegressionData const& data)
{
    constexpr double same = 1e-9;
    auto const runs = data.values.size();
    std::vector<bool> counted(runs, false);
    double sum = 0;
    int degrees = 0;
    for (Index i = 0; i < runs; ++i) {
        if (counted[i])
            continue;
        std::vector<double> values, weights;
        for (Index j = i; j < runs; ++j)
            if (!counted[j] && (data.coded.row(j) - data.coded.row(i)).cwiseAbs().maxCoeff() < same) {
                counted[j] = true;
                values.push_back(data.values[j]);
                weights.push_back(data.weights.size() > 0 ? data.weights[j] : 1);
            }
        auto const map = VectorXd::Map(values.data(), static_cast<Index>(values.size()));
        auto const weight = VectorXd::Map(weights.data(), map.size());
        double const mean = data.weights.size() > 0 ? weight.dot(map) / weight.sum() : map.mean();
        sum += (weight.array() * (map.array() - mean).square()).sum();
        degrees += static_cast<int>(values.size()) - 1;
    }
    return untested("pure error", sum, degrees);
}

} // namespace

std::vector<AnovaRow> analysis_of_variance(Regression const& regression)
{
    auto const& coefficients = regression.coefficients();
    double const total = regression.total_sum_of_squares(), left = regression.residual_sum_of_squares();
    bool const exact = regression.scatter() == Scatter::none;
    auto const residual =
        untested("residual", exact || regression.residual_degrees_of_freedom() == 0 ? 0 : left,
                 regression.residual_degrees_of_freedom());

    std::vector<AnovaRow> rows;
    rows.push_back(tested("model", total - left, static_cast<int>(coefficients.size()) - 1, residual));
    for (std::size_t t = 0; t < coefficients.size(); ++t)
        if (coefficients[t].term.degree() > 0)
            rows.push_back(tested(coefficients[t].term.name(regression.data().factors),
                                  std::pow(coefficients[t].value, 2) /
                                      regression.inverse_root().row(static_cast<Index>(t)).squaredNorm(),
                                  1, residual));
    rows.push_back(residual);
    auto const pure = pure_error(regression.data());
    int const lack_degrees = residual.degrees_of_freedom - pure.degrees_of_freedom;
    if (pure.degrees_of_freedom > 0 && lack_degrees > 0 && pure.sum_of_squares > 0 && !exact) {
        rows.push_back(tested("lack of fit", left - pure.sum_of_squares, lack_degrees, pure));
        rows.push_back(pure);
    }
    rows.push_back(untested("total", total, regression.runs() - 1));
    return rows;
}

std::vector<Effect> pareto(Regression const& regression)
{
    std::vector<Effect> effects;
    for (auto const& coefficient : regression.coefficients())
        if (coefficient.term.degree() > 0)
            effects.push_back({coefficient.term.name(regression.data().factors), 2 * coefficient.value,
                               coefficient.t, coefficient.p});
    bool const tested = regression.scatter() == Scatter::known;
    std::stable_sort(effects.begin(), effects.end(), [tested](Effect const& a, Effect const& b) {
        return tested ? std::abs(a.standardised) > std::abs(b.standardised)
                      : std::abs(a.effect) > std::abs(b.effect);
    });
    return effects;
}

VectorXd influence_shares(RegressionData const& data)
{
    auto const columns = static_cast<int>(data.factors.size());
    Regression const linear(data, polynomial_terms(PolynomialModel::linear, columns));
    int const factors = columns == 0 ? 0 : data.factor(columns - 1) + 1;
    MatrixXd parts = MatrixXd::Zero(data.coded.rows(), factors); // of each factor in each run
    for (int k = 0; k < columns; ++k) {
        VectorXd const column = data.coded.col(k);
        parts.col(data.factor(k)) +=
            linear.coefficients()[k + 1].value * (column.array() - linear.weighted_mean(column)).matrix();
    }
    // The spread of the response divides all of them and drops out.
    VectorXd const shares = parts.colwise().norm();
    return shares / shares.sum();
}

VectorXd variance_inflation(Regression const& regression)
{
    MatrixXd const matrix = model_matrix(regression.terms(), regression.data().coded);
    VectorXd factors(matrix.cols());
    for (Index t = 0; t < matrix.cols(); ++t) {
        VectorXd const column = matrix.col(t);
        Eigen::ArrayXd squares = (column.array() - regression.weighted_mean(column)).square();
        if (regression.data().weights.size() > 0)
            squares *= regression.data().weights.array();
        factors[t] = regression.coefficients()[t].term.degree() == 0
                         ? not_a_number
                         : squares.sum() * regression.inverse_root().row(t).squaredNorm();
    }
    return factors;
}

VectorXd adjusted_response(Regression const& regression, int factor)
{
    auto const& coded = regression.data().coded;
    VectorXd result = regression.residuals();
    for (Index run = 0; run < coded.rows(); ++run) {
        double sum = 0;
        for (Index other = 0; other < coded.rows(); ++other) {
            VectorXd point = coded.row(other).transpose();
            point[factor] = coded(run, factor);
            sum += regression.predict(point);
        }
        result[run] += sum / static_cast<double>(coded.rows());
    }
    return result;
}

std::optional<StationaryPoint> stationary_point(Regression const& regression)
{
    auto const factors = regression.data().coded.cols();
    MatrixXd half_hessian = MatrixXd::Zero(factors, factors);
    for (auto const& coefficient : regression.coefficients()) {
        auto const& exponents = coefficient.term.exponents;
        if (coefficient.term.degree() > 2)
            return std::nullopt;
        if (coefficient.term.degree() < 2)
            continue;
        for (Index i = 0; i < factors; ++i)
            for (Index j = 0; j < factors; ++j) {
                if (i == j && exponents[i] == 2)
                    half_hessian(i, i) = coefficient.value;
                if (i != j && exponents[i] == 1 && exponents[j] == 1)
                    half_hessian(i, j) = 0.5 * coefficient.value;
            }
    }
    Eigen::SelfAdjointEigenSolver<MatrixXd> const solver(half_hessian);
    VectorXd const& curvatures = solver.eigenvalues();
    if (curvatures.cwiseAbs().minCoeff() <= 1e-12 * curvatures.cwiseAbs().maxCoeff())
        return std::nullopt;
    VectorXd const slope = regression.gradient(VectorXd::Zero(factors));
    MatrixXd const& axes = solver.eigenvectors();
    VectorXd const point = -0.5 * (axes * curvatures.cwiseInverse().asDiagonal() * axes.transpose() * slope);
    return StationaryPoint{point, regression.predict(point), curvatures};
}

} // namespace demens::tao_calib
