#include "tao_calib/wave/uncertainty.hpp"

#include "tao_calib/regression/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double threshold_95 = 3.84; // chi-square with one degree of freedom

//! Misfit of the predicted responses, each in units of its noise.
class ChiSquare
{
  public:
    ChiSquare(Assessment const& assessment, VectorXd noise)
        : assessment_(assessment), noise_(std::move(noise))
    {
        targets_.resize(noise_.size());
        for (int t = 0; t < targets_.size(); ++t)
            targets_[t] = assessment.objective().targets()[t].target.value;
    }
    double operator()(VectorXd const& unit) const
    {
        return (assessment_.predict(unit) - targets_).cwiseQuotient(noise_).squaredNorm();
    }
    VectorXd const& noise() const { return noise_; }

  private:
    Assessment const& assessment_;
    VectorXd noise_, targets_;
};

//! A parameter set and its misfit.
struct State
{
    VectorXd unit;
    double chi_square;
};

bool allowed(UnitCube const& cube, VectorXd const& unit)
{
    return unit.minCoeff() >= 0 && unit.maxCoeff() <= 1 && cube.feasible(cube.to_values(unit));
}

//! Symmetric bell of unit variance, bounded by +-3.
double bell(RandomStream& random)
{
    return 2 * (random.uniform() + random.uniform() + random.uniform() - 1.5);
}

//! Draws from exp(-chi2/2) over the feasible cube by differential evolution Markov chains (ter Braak 2006,
//! Stat. Comput. 16, 239): each chain steps along the difference of two others, so that the step adapts to
//! scale and correlation by itself; every tenth step has full length and lets chains change between separate
//! regions.
std::vector<State> draw(Assessment const& assessment, ChiSquare const& chi_square, RandomStream random)
{
    constexpr int generations = 400, discarded = 150;
    UnitCube const& cube = assessment.cube();
    int const k = static_cast<int>(cube.free_factors().size()), chains = std::max(30, 8 * k);
    std::vector<State> population;
    for (int c = 0; c < chains; ++c) {
        // Half of the chains begin around the minima, the others anywhere.
        VectorXd unit = cube.sample(random);
        auto const& minima = assessment.minima();
        if (c % 2 == 0)
            unit = cube.project(0.9 * minima[c / 2 % minima.size()].point + 0.1 * unit);
        population.push_back({unit, chi_square(unit)});
    }

    double const usual = 2.38 / std::sqrt(2.0 * k);
    std::vector<State> draws;
    for (int g = 0; g < generations; ++g) {
        double const length = g % 10 == 9 ? 1.0 : usual;
        for (int c = 0; c < chains; ++c) {
            auto const a = random.below(chains), b = random.below(chains);
            VectorXd proposal = population[c].unit + length * (population[a].unit - population[b].unit);
            for (double& x : proposal)
                x += 1e-3 * bell(random);
            proposal = cube.pinned(proposal);
            double const chance = random.uniform();
            if (allowed(cube, proposal)) {
                double const value = chi_square(proposal);
                if (chance < std::exp(0.5 * (population[c].chi_square - value)))
                    population[c] = {proposal, value};
            }
            if (g >= discarded)
                draws.push_back(population[c]);
        }
    }
    return draws;
}

//! Moves a compatible set as far along one factor as the threshold allows, by random steps of adapted length.
VectorXd pushed(UnitCube const& cube, ChiSquare const& chi_square, double threshold, VectorXd point,
                int factor, double direction, RandomStream& random)
{
    constexpr int steps = 300;
    double length = 0.1;
    for (int i = 0; i < steps; ++i) {
        VectorXd step(point.size());
        for (double& x : step)
            x = length * bell(random);
        step[factor] = direction * std::abs(step[factor]);
        VectorXd const trial = cube.pinned((point + step).cwiseMax(0).cwiseMin(1));
        bool const further = direction * (trial[factor] - point[factor]) > 0;
        if (further && allowed(cube, trial) && chi_square(trial) <= threshold) {
            point = trial;
            length = std::min(0.5, 2 * length);
        } else
            length *= 0.85;
        if (length < 1e-6)
            length = 0.05;
    }
    return point;
}

//! Extents of the compatible sets along each factor [k x 2], unit cube.
MatrixXd extents(Assessment const& assessment, ChiSquare const& chi_square, double threshold,
                 std::vector<State> const& draws, RandomStream random)
{
    int const k = assessment.cube().size();
    VectorXd const& best = assessment.minima().front().point;
    MatrixXd result(k, 2);
    for (int j = 0; j < k; ++j)
        for (int side = 0; side < 2; ++side) {
            double const direction = side == 0 ? -1 : 1;
            VectorXd extreme = best;
            for (auto const& state : draws)
                if (state.chi_square <= threshold && direction * (state.unit[j] - extreme[j]) > 0)
                    extreme = state.unit;
            result(j, side) =
                pushed(assessment.cube(), chi_square, threshold, extreme, j, direction, random)[j];
        }
    return result;
}

MatrixXd correlation(MatrixXd const& rows)
{
    MatrixXd const centred = rows.rowwise() - rows.colwise().mean();
    MatrixXd const covariance = centred.transpose() * centred;
    VectorXd const sd = covariance.diagonal().cwiseSqrt();
    MatrixXd result = MatrixXd::Identity(rows.cols(), rows.cols());
    for (Eigen::Index i = 0; i < rows.cols(); ++i)
        for (Eigen::Index j = 0; j < rows.cols(); ++j)
            if (i != j)
                result(i, j) = sd[i] * sd[j] > 0 ? covariance(i, j) / (sd[i] * sd[j]) : 0;
    return result;
}

//! Noise of the targets at the predicted optimum; a misfit that no factors can remove counts as noise as
//! well.
VectorXd noise_at_optimum(Assessment const& assessment)
{
    VectorXd const& best = assessment.minima().front().point;
    VectorXd const noise =
        (assessment.objective().measurement_sd().cwiseAbs2() + assessment.prediction_sd(best).cwiseAbs2())
            .cwiseSqrt();
    int const degrees = assessment.objective().size() - assessment.cube().size();
    double const misfit = ChiSquare(assessment, noise)(best);
    return degrees > 0 && misfit > degrees ? VectorXd(noise * std::sqrt(misfit / degrees)) : noise;
}

} // namespace

char const* name_of(Verdict verdict)
{
    switch (verdict) {
    case Verdict::determined:
        return "determined";
    case Verdict::weakly:
        return "weakly determined";
    case Verdict::not_determined:
        return "not determined by these targets";
    case Verdict::fixed:
        return "fixed: inactive in the screening";
    }
    return "";
}

double misfit(Assessment const& assessment, VectorXd const& target_noise, VectorXd const& unit)
{
    return ChiSquare(assessment, target_noise)(unit);
}

FactorUncertainty factor_uncertainty(Assessment const& assessment, std::uint64_t seed)
{
    UnitCube const& cube = assessment.cube();
    int const k = cube.size();
    ChiSquare const chi_square(assessment, noise_at_optimum(assessment));
    auto const draws = draw(assessment, chi_square, RandomStream(derive_seed(seed, 1)));
    double const threshold = chi_square(assessment.minima().front().point) + threshold_95;
    MatrixXd const unit_extents =
        extents(assessment, chi_square, threshold, draws, RandomStream(derive_seed(seed, 2)));

    MatrixXd values(static_cast<Eigen::Index>(draws.size()), k);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        values.row(i) = cube.to_values(draws[i].unit).transpose();
    MatrixXd const centred = values.rowwise() - values.colwise().mean();

    FactorUncertainty result;
    result.target_noise = chi_square.noise();
    result.least_misfit = threshold - threshold_95;
    result.region_90 =
        result.least_misfit + chi_square_quantile(0.9, static_cast<double>(cube.free_factors().size()));
    constexpr Eigen::Index most_draws = 400;
    auto const stride = std::max<Eigen::Index>(1, values.rows() / most_draws);
    result.draws.resize((values.rows() + stride - 1) / stride, k);
    for (Eigen::Index i = 0; i < result.draws.rows(); ++i)
        result.draws.row(i) = draws[static_cast<std::size_t>(i * stride)].unit.transpose();
    result.standard_errors = (centred.cwiseAbs2().colwise().mean()).cwiseSqrt().transpose();
    result.correlations = correlation(values);
    result.intervals.resize(k, 2);
    result.intervals.col(0) = cube.to_values(unit_extents.col(0));
    result.intervals.col(1) = cube.to_values(unit_extents.col(1));
    for (int j = 0; j < k; ++j) {
        double const width = unit_extents(j, 1) - unit_extents(j, 0);
        if (!cube.is_free(j)) {
            result.verdicts.push_back(Verdict::fixed);
            continue;
        }
        result.verdicts.push_back(width < 0.5   ? Verdict::determined
                                  : width < 0.9 ? Verdict::weakly
                                                : Verdict::not_determined);
    }
    return result;
}

} // namespace demens::tao_calib
