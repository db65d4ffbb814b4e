#include "tao_calib/surrogate/radial_basis.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cassert>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double cubic(double distance)
{
    return distance * distance * distance;
}

MatrixXd tail_rows(MatrixXd const& points)
{
    MatrixXd rows(points.rows(), points.cols() + 1);
    rows << VectorXd::Ones(points.rows()), points;
    return rows;
}

} // namespace

//! The smoothing system (Phi + smoothing W^-1) c + P d = y, P'c = 0, made ready for any smoothing: with S =
//! W^(1/2) and an orthonormal basis Q of the complement of S P, the symmetric matrix Q' S Phi S Q is positive
//! definite (the cubic is conditionally positive definite of order two) and is diagonalised once.
struct RadialBasis::System
{
    explicit System(Samples const& samples)
        : scale(samples.weights.cwiseSqrt()), tail(scale.asDiagonal() * tail_rows(samples.points)),
          tail_qr(tail)
    {
        Eigen::Index const n = samples.points.rows(), q = tail.cols();
        kernel.resize(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                kernel(i, j) =
                    scale[i] * cubic((samples.points.row(i) - samples.points.row(j)).norm()) * scale[j];
        MatrixXd const complement = MatrixXd(tail_qr.householderQ()).rightCols(n - q);
        Eigen::SelfAdjointEigenSolver<MatrixXd> const eigen(complement.transpose() * kernel * complement);
        eigenvalues = eigen.eigenvalues();
        modes = complement * eigen.eigenvectors();
    }

    //! Eigenvalues of the matrix to be inverted; rounding below zero does not count.
    VectorXd shifted(double smoothing) const
    {
        double const floor = 1e-14 * eigenvalues.maxCoeff();
        return (eigenvalues.array() + smoothing).max(floor);
    }

    //! Leave-one-out errors c_i/(A^-1)_ii (Rippa 1999), which hold with smoothing and tail as well.
    VectorXd leave_one_out(VectorXd const& values, double smoothing) const
    {
        VectorXd const inverse = shifted(smoothing).cwiseInverse();
        VectorXd const scaled = scale.cwiseProduct(values);
        VectorXd const coefficients = modes * inverse.cwiseProduct(modes.transpose() * scaled);
        VectorXd const diagonal = modes.cwiseAbs2() * inverse;
        return coefficients.cwiseQuotient(diagonal.cwiseProduct(scale));
    }

    VectorXd scale; //!< square roots of the weights
    MatrixXd tail;  //!< S P
    Eigen::HouseholderQR<MatrixXd> tail_qr;
    MatrixXd kernel; //!< S Phi S
    VectorXd eigenvalues;
    MatrixXd modes;
};

bool RadialBasis::can_fit(Samples const& samples)
{
    Eigen::Index const q = samples.points.cols() + 1;
    return samples.points.rows() > q &&
           Eigen::ColPivHouseholderQR<MatrixXd>(tail_rows(samples.points)).rank() == q;
}

RadialBasis::RadialBasis(Samples const& samples) : points_(samples.points)
{
    assert(can_fit(samples));
    System const system(samples);
    double const typical = system.eigenvalues.mean();
    double best = 0, best_square = std::numeric_limits<double>::infinity();
    constexpr int first = -16, last = 8; // half decades around the typical eigenvalue
    for (int step = first - 1; step <= last; ++step) {
        double const candidate = step < first ? 0 : typical * std::pow(10.0, 0.5 * step);
        VectorXd const errors = system.leave_one_out(samples.values, candidate);
        double const square = samples.weights.dot(errors.cwiseAbs2());
        if (square < best_square)
            best = candidate, best_square = square;
    }
    solve(system, samples, best);
}

RadialBasis::RadialBasis(Samples const& samples, double smoothing) : points_(samples.points)
{
    assert(can_fit(samples) && smoothing >= 0);
    solve(System(samples), samples, smoothing);
}

void RadialBasis::solve(System const& system, Samples const& samples, double smoothing)
{
    Eigen::Index const n = points_.rows(), q = system.tail.cols();
    smoothing_ = smoothing;
    MatrixXd const inverse =
        system.modes * system.shifted(smoothing).cwiseInverse().asDiagonal() * system.modes.transpose();
    MatrixXd const rest = MatrixXd::Identity(n, n) - system.kernel * inverse - smoothing * inverse;
    influence_.resize(n + q, n);
    influence_.topRows(n) = system.scale.asDiagonal() * inverse * system.scale.asDiagonal();
    influence_.bottomRows(q) = system.tail_qr.solve(rest) * system.scale.asDiagonal();
    coefficients_ = influence_.topRows(n) * samples.values;
    tail_ = influence_.bottomRows(q) * samples.values;
    leave_one_out_ = system.leave_one_out(samples.values, smoothing);
    // The errors are c_i/(dc_i/dy_i), and the coefficients c are linear in the values.
    MatrixXd const coefficients = influence_.topRows(n);
    error_ = run_error(leave_one_out_, coefficients.diagonal().cwiseInverse().asDiagonal() * coefficients,
                       samples.weights);
    influence_ *= system.scale.cwiseInverse().asDiagonal();
}

double RadialBasis::value(VectorXd const& point) const
{
    double sum = tail_[0] + tail_.tail(point.size()).dot(point);
    for (Eigen::Index i = 0; i < points_.rows(); ++i)
        sum += coefficients_[i] * cubic((points_.row(i).transpose() - point).norm());
    return sum;
}

VectorXd RadialBasis::gradient(VectorXd const& point) const
{
    VectorXd slope = tail_.tail(point.size());
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
        VectorXd const apart = point - points_.row(i).transpose();
        slope += 3 * coefficients_[i] * apart.norm() * apart;
    }
    return slope;
}

//! The prediction is linear in the values, s(x) = sum_i l_i(x) y_i; independent errors of the values, each a
//! mean over w_i runs of the leave-one-out variance, give it the variance of the weighted sum, error^2 sum_i
//! l_i^2/w_i.
double RadialBasis::standard_deviation(VectorXd const& point) const
{
    Eigen::Index const n = points_.rows();
    VectorXd row(influence_.rows());
    for (Eigen::Index i = 0; i < n; ++i)
        row[i] = cubic((points_.row(i).transpose() - point).norm());
    row[n] = 1;
    row.tail(point.size()) = point;
    return error_.sd * (influence_.transpose() * row).norm();
}

} // namespace demens::tao_calib
