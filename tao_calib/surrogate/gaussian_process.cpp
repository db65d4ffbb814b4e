#include "tao_calib/surrogate/gaussian_process.hpp"

#include "tao_calib/solver/bounded_minimum.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double shortest = 0.05, longest = 20; // lengths, in shares of the ranges
constexpr double least_noise = 1e-8, most_noise = 10;
constexpr double usual_length = 1, length_spread = 1.2; // prior: log-normal

//! Matern 5/2 at a scaled distance r, and -(1/r) of its derivative.
struct Matern
{
    explicit Matern(double r)
    {
        double const s = std::sqrt(5.0) * r, decay = std::exp(-s);
        value = (1 + s + s * s / 3) * decay;
        slope = 5.0 / 3 * (1 + s) * decay;
    }
    double value, slope;
};

double scaled_distance(VectorXd const& difference, VectorXd const& lengths)
{
    return difference.cwiseQuotient(lengths).norm();
}

Kriging krige(Samples const& samples, Correlation const& correlation)
{
    Index const n = samples.points.rows();
    MatrixXd matrix(n, n);
    for (Index i = 0; i < n; ++i) {
        matrix(i, i) = 1 + correlation.noise / samples.weights[i];
        for (Index j = 0; j < i; ++j)
            matrix(i, j) = matrix(j, i) =
                Matern(scaled_distance((samples.points.row(i) - samples.points.row(j)).transpose(),
                                       correlation.lengths))
                    .value;
    }
    return Kriging(matrix, VectorXd::Ones(n), samples.values);
}

Correlation from_logarithms(VectorXd const& logarithms)
{
    Index const k = logarithms.size() - 1;
    return {logarithms.head(k).array().exp(), std::exp(logarithms[k])};
}

Correlation most_likely(Samples const& samples)
{
    Index const k = samples.points.cols();
    CorrelationLikelihood const likelihood(samples);
    BoundedFunction const function{
        [&](VectorXd const& x, VectorXd* gradient) { return likelihood(x, gradient); },
        VectorXd::Constant(k + 1, std::log(shortest)), VectorXd::Constant(k + 1, std::log(longest))};
    BoundedFunction bounded = function;
    bounded.lower[k] = std::log(least_noise), bounded.upper[k] = std::log(most_noise);
    constexpr std::array<std::array<double, 2>, 3> starts{{{0.3, 1e-2}, {1.0, 1e-6}, {2.5, 1e-2}}};
    BoundedMinimum best;
    best.value = std::numeric_limits<double>::infinity();
    for (auto const& [length, noise] : starts) {
        VectorXd start = VectorXd::Constant(k + 1, std::log(length));
        start[k] = std::log(noise);
        auto found =
            minimise(Minimiser::quasi_newton, bounded, start, {.tolerance = 1e-5, .evaluations = 80});
        if (found.value < best.value)
            best = std::move(found);
    }
    return from_logarithms(best.point);
}

} // namespace

CorrelationLikelihood::CorrelationLikelihood(Samples const& samples)
    : noise_shares_(samples.weights.cwiseInverse())
{
    for (Index j = 0; j < samples.points.cols(); ++j) {
        auto const column = samples.points.col(j);
        auto const ones = Eigen::RowVectorXd::Ones(column.size());
        squared_differences_.push_back((column * ones - ones.transpose() * column.transpose()).cwiseAbs2());
    }
    auto const n = static_cast<double>(samples.values.size());
    VectorXd const about_mean = samples.values.array() - samples.values.mean();
    double const spread = std::sqrt(about_mean.squaredNorm() / n);
    double const unit = spread > 0 ? spread : 1;
    centred_ = about_mean / unit;
    if (samples.squared_deviations.size() > 0) {
        replicate_squares_ = samples.squared_deviations.sum() / (unit * unit);
        replicate_degrees_ = samples.weights.sum() - n;
    }
}

double CorrelationLikelihood::operator()(VectorXd const& logarithms, VectorXd* gradient) const
{
    auto const correlation = from_logarithms(logarithms);
    Index const n = centred_.size(), k = correlation.lengths.size();
    MatrixXd distances = MatrixXd::Zero(n, n);
    for (Index j = 0; j < k; ++j)
        distances += squared_differences_[j] / (correlation.lengths[j] * correlation.lengths[j]);
    MatrixXd matrix(n, n), slopes(n, n);
    for (Index i = 0; i < n * n; ++i) {
        Matern const matern(std::sqrt(distances.data()[i]));
        matrix.data()[i] = matern.value;
        slopes.data()[i] = matern.slope;
    }
    matrix.diagonal() += correlation.noise * noise_shares_;
    Kriging const kriging(matrix, VectorXd::Ones(n), centred_);
    if (!kriging.sound())
        return std::numeric_limits<double>::infinity();
    double const degrees = static_cast<double>(n) - 1 + replicate_degrees_;
    double const squares =
        std::max(kriging.quadratic_form() + replicate_squares_ / correlation.noise, 1e-300);
    VectorXd const beside = (logarithms.head(k).array() - std::log(usual_length)) / length_spread;
    double const value = degrees * std::log(squares / degrees) + kriging.log_determinants() +
                         replicate_degrees_ * logarithms[k] + beside.squaredNorm();
    if (!gradient)
        return value;

    // d/dt = tr(P dK/dt) - (degrees/squares) w' dK/dt w, P the projector and w = P y.
    MatrixXd const sensitivity =
        kriging.projector() - degrees / squares * kriging.weights() * kriging.weights().transpose();
    MatrixXd const by_distance = sensitivity.cwiseProduct(slopes);
    gradient->resize(k + 1);
    for (Index j = 0; j < k; ++j)
        (*gradient)[j] = by_distance.cwiseProduct(squared_differences_[j]).sum() /
                             (correlation.lengths[j] * correlation.lengths[j]) +
                         2 / length_spread * beside[j];
    (*gradient)[k] = correlation.noise * sensitivity.diagonal().dot(noise_shares_) -
                     degrees / squares * replicate_squares_ / correlation.noise + replicate_degrees_;
    return value;
}

bool GaussianProcess::can_fit(Samples const& samples)
{
    if (samples.points.rows() < samples.points.cols() + 3)
        return false;
    return samples.values.maxCoeff() > samples.values.minCoeff();
}

GaussianProcess::GaussianProcess(Samples const& samples) : GaussianProcess(samples, most_likely(samples)) {}

GaussianProcess::GaussianProcess(Samples const& samples, Correlation correlation)
    : points_(samples.points), correlation_(std::move(correlation)), kriging_(krige(samples, correlation_))
{
    // A correlation that is singular in double precision is made sound by more noise.
    while (!kriging_.sound()) {
        correlation_.noise = std::max(10 * correlation_.noise, 1e-12);
        kriging_ = krige(samples, correlation_);
    }
    double degrees = static_cast<double>(samples.values.size()) - 1;
    double squares = kriging_.quadratic_form();
    if (samples.squared_deviations.size() > 0 && correlation_.noise > 0) {
        squares += samples.squared_deviations.sum() / correlation_.noise;
        degrees += samples.weights.sum() - static_cast<double>(samples.values.size());
    }
    variance_ = squares / degrees;
    leave_one_out_ = kriging_.leave_one_out_errors();
    run_shares_ = samples.weights.cwiseInverse();
    MatrixXd const& projector = kriging_.projector();
    error_ = run_error(leave_one_out_, projector.diagonal().cwiseInverse().asDiagonal() * projector,
                       samples.weights);
}

VectorXd GaussianProcess::correlations(VectorXd const& point) const
{
    VectorXd result(points_.rows());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = Matern(scaled_distance(point - points_.row(i).transpose(), correlation_.lengths)).value;
    return result;
}

double GaussianProcess::value(VectorXd const& point) const
{
    return kriging_.mean(correlations(point), VectorXd::Ones(1));
}

VectorXd GaussianProcess::gradient(VectorXd const& point) const
{
    VectorXd slope = VectorXd::Zero(point.size());
    for (Index i = 0; i < points_.rows(); ++i) {
        VectorXd const apart = point - points_.row(i).transpose();
        slope -= kriging_.weights()[i] * Matern(scaled_distance(apart, correlation_.lengths)).slope * apart;
    }
    return slope.cwiseQuotient(correlation_.lengths.cwiseAbs2());
}

double GaussianProcess::standard_deviation(VectorXd const& point) const
{
    return std::sqrt(variance_ * kriging_.variance(correlations(point), VectorXd::Ones(1), 1.0));
}

//! The posterior is right where its assumptions are. The mean is linear in the values, so that runs which
//! scatter as the leave-one-out errors tell leave it error^2 sum_i l_i^2/w_i at least.
double GaussianProcess::supported_deviation(VectorXd const& point) const
{
    VectorXd const shares = kriging_.shares(correlations(point), VectorXd::Ones(1));
    return std::max(standard_deviation(point), error_.sd * std::sqrt(shares.cwiseAbs2().dot(run_shares_)));
}

double GaussianProcess::run_sd() const
{
    return std::sqrt(variance_ * correlation_.noise);
}

} // namespace demens::tao_calib
