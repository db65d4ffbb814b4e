#include "tao_calib/surrogate/polynomial.hpp"

#include <Eigen/QR>
#include <cassert>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

//! Terms at one point: 1; z_i; z_i^2; z_i z_j, with z in [-1, 1].
VectorXd basis(SurrogateKind kind, VectorXd const& point)
{
    VectorXd const z = 2 * point.array() - 1;
    Eigen::Index const k = z.size();
    VectorXd row(Polynomial::terms(kind, static_cast<int>(k)));
    Eigen::Index next = 0;
    row[next++] = 1;
    if (kind >= SurrogateKind::linear)
        for (Eigen::Index i = 0; i < k; ++i)
            row[next++] = z[i];
    if (kind >= SurrogateKind::linear_and_squares)
        for (Eigen::Index i = 0; i < k; ++i)
            row[next++] = z[i] * z[i];
    if (kind >= SurrogateKind::quadratic)
        for (Eigen::Index i = 0; i < k; ++i)
            for (Eigen::Index j = i + 1; j < k; ++j)
                row[next++] = z[i] * z[j];
    return row;
}

MatrixXd weighted_basis(SurrogateKind kind, Samples const& samples)
{
    MatrixXd rows(samples.points.rows(), Polynomial::terms(kind, static_cast<int>(samples.points.cols())));
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        rows.row(i) =
            std::sqrt(samples.weights[i]) * basis(kind, samples.points.row(i).transpose()).transpose();
    return rows;
}

} // namespace

int Polynomial::terms(SurrogateKind kind, int k)
{
    switch (kind) {
    case SurrogateKind::constant:
        return 1;
    case SurrogateKind::linear:
        return 1 + k;
    case SurrogateKind::linear_and_squares:
        return 1 + 2 * k;
    default:
        return 1 + 2 * k + k * (k - 1) / 2;
    }
}

bool Polynomial::can_fit(SurrogateKind kind, Samples const& samples)
{
    int const needed = terms(kind, static_cast<int>(samples.points.cols()));
    if (samples.points.rows() <= needed)
        return false;
    return Eigen::ColPivHouseholderQR<MatrixXd>(weighted_basis(kind, samples)).rank() == needed;
}

std::unique_ptr<Polynomial> Polynomial::best_up_to(SurrogateKind richest, Samples const& samples)
{
    auto best = std::make_unique<Polynomial>(SurrogateKind::constant, samples);
    double least = leave_one_out_rmse(*best, samples);
    for (auto kind : {SurrogateKind::linear, SurrogateKind::linear_and_squares, SurrogateKind::quadratic}) {
        if (kind > richest || !can_fit(kind, samples))
            continue;
        auto candidate = std::make_unique<Polynomial>(kind, samples);
        if (double const error = leave_one_out_rmse(*candidate, samples); error < least) {
            best = std::move(candidate);
            least = error;
        }
    }
    return best;
}

Polynomial::Polynomial(SurrogateKind kind, Samples const& samples) : kind_(kind)
{
    assert(kind <= SurrogateKind::quadratic && samples.points.rows() > 0);
    VectorXd const root_weights = samples.weights.cwiseSqrt();
    MatrixXd const rows = weighted_basis(kind, samples);
    VectorXd const values = root_weights.cwiseProduct(samples.values);
    Eigen::ColPivHouseholderQR<MatrixXd> const qr(rows);
    coefficients_ = qr.solve(values);
    VectorXd const residuals = values - rows * coefficients_;
    residual_sum_of_squares_ = residuals.squaredNorm();

    // (X'X)^-1 = P R^-1 R^-T P', and the leverage of a row is the squared norm of its row of Q.
    MatrixXd const triangle = qr.matrixR().topRows(rows.cols()).triangularView<Eigen::Upper>();
    MatrixXd const inverse =
        qr.colsPermutation() *
        MatrixXd(triangle.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(rows.cols(), rows.cols())));
    covariance_ = inverse * inverse.transpose();
    VectorXd const leverages = (rows * inverse).rowwise().squaredNorm();
    leave_one_out_ = residuals.array() / root_weights.array() / (1 - leverages.array()).max(1e-12);
    error_ =
        run_error_of_regression(leave_one_out_, leverages, samples.weights, static_cast<int>(rows.cols()));
}

double Polynomial::value(VectorXd const& point) const
{
    return basis(kind_, point).dot(coefficients_);
}

VectorXd Polynomial::gradient(VectorXd const& point) const
{
    VectorXd const z = 2 * point.array() - 1;
    Eigen::Index const k = z.size();
    VectorXd slope = VectorXd::Zero(k);
    if (kind_ >= SurrogateKind::linear)
        slope += coefficients_.segment(1, k);
    if (kind_ >= SurrogateKind::linear_and_squares)
        slope += 2 * coefficients_.segment(1 + k, k).cwiseProduct(z);
    if (kind_ >= SurrogateKind::quadratic)
        for (Eigen::Index i = 0, next = 1 + 2 * k; i < k; ++i)
            for (Eigen::Index j = i + 1; j < k; ++j, ++next) {
                slope[i] += coefficients_[next] * z[j];
                slope[j] += coefficients_[next] * z[i];
            }
    return 2 * slope;
}

//! The covariance is (X'WX)^-1, so that the error is that of a single run: a mean over w runs has 1/w of its
//! variance, and the weights enter once.
double Polynomial::standard_deviation(VectorXd const& point) const
{
    VectorXd const row = basis(kind_, point);
    return error_.sd * std::sqrt(row.dot(covariance_ * row));
}

} // namespace demens::tao_calib
