#include "gap/statistics/quantify.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/gaussian.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check(HeldOut const& held_out, HeldOutPrediction const& prediction)
{
    auto const m = static_cast<Eigen::Index>(held_out.cells.size());
    if (prediction.packings.rows() < 1 || prediction.packings.cols() != m)
        throw InputError(
            fmt::format("a held-out prediction is [{} x {}]: it must have a row for each packing, "
                        "at least one, and a column for each of {} cells",
                        prediction.packings.rows(), prediction.packings.cols(), m));
    for (Eigen::Index j = 0; j < m; ++j)
        if (!prediction.packings.col(j).allFinite())
            throw InputError(fmt::format("held-out cell `{}`: a prediction is not a number: leave that "
                                         "packing out, or the cell",
                                         held_out.cells[j].name));
    if (prediction.estimation.size() > 0 &&
        (prediction.estimation.rows() != m || prediction.estimation.cols() != m))
        throw InputError(fmt::format("`estimation` of a held-out prediction must be [{} x {}]", m, m));
}

//! One experiment of those held out.
struct Block
{
    std::vector<int> cells;
    Eigen::LLT<MatrixXd> floor;
    MatrixXd measurement_root; //!< of the experiment's part of the floor
    MatrixXd packings_before, packings_after;
    VectorXd measured;
    double estimation_before, estimation_after; //!< traces over the floor
    double resampling_before, resampling_after; //!< what resampling itself adds to the squares, in the mean
};

double trace(Eigen::LLT<MatrixXd> const& floor, MatrixXd const& covariance)
{
    return MatrixXd(floor.solve(covariance)).trace();
}

double estimation_trace(Block const& block, HeldOutPrediction const& prediction)
{
    return prediction.estimation.size() > 0
               ? trace(block.floor, prediction.estimation(block.cells, block.cells))
               : 0;
}

double resampling_trace(Block const& block, MatrixXd const& packings)
{
    auto const runs = static_cast<double>(packings.rows());
    MatrixXd const centred = packings.rowwise() - packings.colwise().mean();
    return trace(block.floor, centred.transpose() * centred / (runs * runs));
}

std::vector<Block> blocks(HeldOut const& held_out, HeldOutPrediction const& before,
                          HeldOutPrediction const& after)
{
    MatrixXd const floor = held_out.floor.total();
    std::vector<Block> found;
    for (auto& group : groups_by_experiment(held_out.cells)) {
        Block block{};
        block.cells = std::move(group.cells);
        block.floor.compute(floor(block.cells, block.cells));
        MatrixXd const measurement = held_out.floor.experiment(block.cells, block.cells);
        block.measurement_root = square_root(measurement);
        block.packings_before = before.packings(Eigen::all, block.cells);
        block.packings_after = after.packings(Eigen::all, block.cells);
        block.measured = held_out.measured(block.cells);
        block.estimation_before = estimation_trace(block, before);
        block.estimation_after = estimation_trace(block, after);
        double const measured = trace(block.floor, measurement);
        block.resampling_before = measured + resampling_trace(block, block.packings_before);
        block.resampling_after = measured + resampling_trace(block, block.packings_after);
        found.push_back(std::move(block));
    }
    return found;
}

double square(Eigen::LLT<MatrixXd> const& floor, VectorXd const& residual)
{
    return residual.dot(floor.solve(residual));
}

VectorXd resampled_mean(MatrixXd const& packings, RandomStream& random)
{
    VectorXd sum = VectorXd::Zero(packings.cols());
    for (Eigen::Index i = 0; i < packings.rows(); ++i)
        sum += packings.row(static_cast<Eigen::Index>(random.below(packings.rows()))).transpose();
    return sum / static_cast<double>(packings.rows());
}

//! Closure of resampled data; empty where nothing is left to close.
double resampled_closure(std::vector<Block> const& all, RandomStream random)
{
    double before = 0, after = 0;
    for (std::size_t draw = 0; draw < all.size(); ++draw) {
        auto const& block = all[random.below(all.size())];
        VectorXd const measured =
            block.measured +
            block.measurement_root * standard_normals(static_cast<Eigen::Index>(block.cells.size()), random);
        auto const own = static_cast<double>(block.cells.size());
        before += square(block.floor, measured - resampled_mean(block.packings_before, random)) - own -
                  block.estimation_before - block.resampling_before;
        after += square(block.floor, measured - resampled_mean(block.packings_after, random)) - own -
                 block.estimation_after - block.resampling_after;
    }
    return before > 0 ? std::min(1 - after / before, 1.0) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

HeldOut held_out(Evidence const& evidence)
{
    if (evidence.cells.empty())
        throw InputError("no experiment is held out: how far an effect closes the gap can only be said on "
                         "experiments that took no part in the fit; name some in `held_out`");
    auto floor = make_floor(evidence);
    checked_root(floor.total(), evidence.cells);
    return {evidence.cells, evidence.measured, std::move(floor)};
}

MatrixXd estimation_covariance(Evidence const& fitted, Projection const& projection, Evidence const& held_out,
                               std::vector<Signature> const& effects_fitted,
                               std::vector<Signature> const& effects_held_out)
{
    auto const p = fitted.factors();
    auto const columns = p + static_cast<Eigen::Index>(effects_fitted.size());
    MatrixXd fit(fitted.size(), columns), other(held_out.size(), columns),
        prior = MatrixXd::Zero(columns, columns);
    fit.leftCols(p) = fitted.nuisance;
    other.leftCols(p) = held_out.nuisance;
    prior.topLeftCorner(p, p) = fitted.nuisance_prior;
    for (std::size_t k = 0; k < effects_fitted.size(); ++k) {
        auto const column = p + static_cast<Eigen::Index>(k);
        fit.col(column) = effects_fitted[k].first;
        other.col(column) = effects_held_out[k].first;
        prior(column, column) = std::pow(effects_fitted[k].typical, 2);
    }
    Eigen::LLT<MatrixXd> const total(projection.floor() + fit * prior * fit.transpose());
    MatrixXd const gain = prior * fit.transpose() * total.solve(MatrixXd::Identity(fit.rows(), fit.rows()));
    MatrixXd const posterior = prior - gain * fit * prior;
    MatrixXd const common = (fitted.form_floor * scales(fitted.cells)).asDiagonal() *
                            form_correlation(fitted.cells, held_out.cells, fitted.correlation_length) *
                            (held_out.form_floor * scales(held_out.cells)).asDiagonal();
    MatrixXd const crossed = other * gain * common;
    return other * posterior * other.transpose() - crossed - crossed.transpose();
}

ExcessMisfit excess_misfit(HeldOut const& held_out, HeldOutPrediction const& prediction)
{
    check(held_out, prediction);
    MatrixXd covariance = held_out.floor.total();
    auto const m = covariance.rows();
    ExcessMisfit found{};
    double estimation = 0;
    MatrixXd inverse = MatrixXd::Zero(m, m); // of the experiments' blocks
    for (auto const& block : blocks(held_out, prediction, prediction)) {
        VectorXd const mean = block.packings_before.colwise().mean();
        found.square += square(block.floor, block.measured - mean) / static_cast<double>(m);
        estimation += block.estimation_before / static_cast<double>(m);
        auto const own = static_cast<Eigen::Index>(block.cells.size());
        inverse(block.cells, block.cells) = MatrixXd(block.floor.solve(MatrixXd::Identity(own, own)));
    }
    found.excess = found.square - 1 - estimation;
    // The sum of squares by a chi-square of the same mean and variance (Satterthwaite 1946).
    if (prediction.estimation.size() > 0)
        covariance += prediction.estimation;
    MatrixXd const ratio = inverse * covariance;
    double const mean = ratio.trace(), variance = 2 * (ratio * ratio).trace();
    double const degrees = 2 * mean * mean / variance;
    found.floor_limit =
        tao_calib::chi_square_quantile(0.95, degrees) * mean / degrees / static_cast<double>(m);
    return found;
}

Closure quantify(HeldOut const& held_out, HeldOutPrediction const& before, HeldOutPrediction const& after,
                 QuantifyOptions const& options)
{
    if (options.resamples < 1 || !(options.confidence > 0 && options.confidence < 1))
        throw InputError(fmt::format("`resamples` is {} and `confidence` {}: at least 1, and between 0 and 1",
                                     options.resamples, options.confidence));
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    Closure found{};
    found.before = excess_misfit(held_out, before);
    found.after = excess_misfit(held_out, after);
    found.at_floor = found.before.at_floor() || found.before.excess <= 0;
    VectorXd const sd = held_out.floor.deviations();
    for (Eigen::Index j = 0; j < sd.size(); ++j)
        found.cells.push_back({held_out.measured[j] - before.packings.col(j).mean(),
                               held_out.measured[j] - after.packings.col(j).mean(), sd[j]});
    found.closure = found.lower = found.upper = not_a_number;
    if (found.at_floor)
        return found;
    found.closure = std::min(1 - found.after.excess / found.before.excess, 1.0);

    auto const all = blocks(held_out, before, after);
    std::vector<double> closures;
    for (int i = 0; i < options.resamples; ++i) {
        double const closure = resampled_closure(all, RandomStream(derive_seed(options.seed, i)));
        found.resamples_at_floor += std::isnan(closure) / static_cast<double>(options.resamples);
        closures.push_back(std::isnan(closure) ? 0 : closure);
    }
    // Resamples of k experiments scatter by sqrt((k - 1) / k) too little.
    auto const experiments = static_cast<double>(all.size());
    double const wider = experiments > 1 ? std::sqrt(experiments / (experiments - 1)) : 1;
    auto end = [&](double share) {
        return std::min(found.closure + wider * (quantile(closures, share) - found.closure), 1.0);
    };
    found.lower = end(0.5 * (1 - options.confidence));
    found.upper = end(0.5 * (1 + options.confidence));
    return found;
}

} // namespace demens::gap
