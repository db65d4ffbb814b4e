#include "tao_calib/wave/uncertainty.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/regression/distributions.hpp"
#include "tao_calib/wave/feasibility.hpp"
#include "tao_calib/wave/simulated_extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double threshold_95 = 3.84; // chi-square with one degree of freedom
constexpr double even = 0.5;          // chance of a good run below which an estimate is none

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
std::vector<State> draw(Assessment const& assessment, ChiSquare const& chi_square, VectorXd const& best,
                        RandomStream random)
{
    constexpr int generations = 400, discarded = 150;
    UnitCube const& cube = assessment.cube();
    int const k = static_cast<int>(cube.free_factors().size()), chains = std::max(30, 8 * k);
    std::vector<State> population;
    for (int c = 0; c < chains; ++c) {
        // Half of the chains begin around the estimate and the minima, the others anywhere.
        VectorXd unit = cube.sample(random);
        auto const& minima = assessment.minima();
        if (c % 2 == 0) {
            auto const turn = static_cast<std::size_t>(c) / 2 % (minima.size() + 1);
            unit = cube.project(0.9 * (turn == 0 ? best : minima[turn - 1].point) + 0.1 * unit);
        }
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

//! Least chi2 with one factor on a bound, sought from a set that lies there.
double least_on_bound(Assessment const& assessment, ChiSquare const& chi_square, VectorXd const& there,
                      int factor)
{
    double least = chi_square(there);
    if (assessment.cube().free_factors().size() < 2)
        return least;
    try {
        auto const cube = assessment.cube().with_fixed(factor, there[factor]);
        LeastSquaresProblem const problem{cube.size(), assessment.objective().size(),
                                          [&](VectorXd const& unit) { return chi_square.residuals(unit); },
                                          [&](VectorXd const& unit) { return chi_square.slopes(unit); }};
        least = std::min(least, minimum_from(assessment.solver(), problem, cube, there).sum_of_squares);
    } catch (InputError const&) { // the constraints leave no room on the bound
    }
    return least;
}

//! Where the interval would end if there were no bound: the profile of chi2 is continued as a parabola.
double without_bound(Assessment const& assessment, ChiSquare const& chi_square, VectorXd const& best,
                     VectorXd const& extreme, int factor)
{
    double const rise = least_on_bound(assessment, chi_square, extreme, factor) - chi_square(best);
    double const distance = extreme[factor] - best[factor];
    if (distance == 0)
        return extreme[factor]; // the estimate itself is on the bound
    return rise > 0 ? best[factor] + distance * std::max(1.0, std::sqrt(threshold_95 / rise))
                    : std::copysign(HUGE_VAL, distance);
}

//! Extents of the compatible sets along a factor.
FactorEvidence evidence_on(Assessment const& assessment, ChiSquare const& chi_square, VectorXd const& best,
                           std::vector<State> const& draws, int factor, RandomStream& random)
{
    constexpr double at_bound = 1e-6;
    double const threshold = chi_square(best) + threshold_95;
    FactorEvidence evidence{&assessment.cube().factor(factor), best[factor], {}, {}};
    for (double const direction : {-1.0, 1.0}) {
        VectorXd extreme = best;
        for (auto const& state : draws)
            if (state.chi_square <= threshold && direction * (state.unit[factor] - extreme[factor]) > 0)
                extreme = state.unit;
        auto& end = direction < 0 ? evidence.lower : evidence.upper;
        end.point = pushed(assessment.cube(), chi_square, threshold, extreme, factor, direction, random);
        double const place = end.point[factor];
        end.at_bound = direction < 0 ? place <= at_bound : place >= 1 - at_bound;
        end.without_bound =
            end.at_bound ? without_bound(assessment, chi_square, best, end.point, factor) : place;
    }
    // An estimate on a bound is as uncertain towards the outside as towards the inside.
    auto mirror = [&](IntervalEnd& end, IntervalEnd const& other) {
        if (end.at_bound && end.point[factor] == best[factor])
            end.without_bound = 2 * best[factor] - other.without_bound;
    };
    mirror(evidence.lower, evidence.upper);
    mirror(evidence.upper, evidence.lower);
    return evidence;
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

//! Whether runs more probably fail than not at the estimate, or nearly always at an end of the interval.
bool rests_on_failures(Feasibility const& feasibility, VectorXd const& best, FactorEvidence const& evidence)
{
    return feasibility.chance(best) < even || feasibility.chance(evidence.lower.point) < 0.25 ||
           feasibility.chance(evidence.upper.point) < 0.25;
}

bool determines(Verdict verdict)
{
    return verdict == Verdict::determined || verdict == Verdict::weakly;
}

} // namespace

double misfit(Assessment const& assessment, VectorXd const& target_noise, VectorXd const& unit)
{
    return ChiSquare(assessment, target_noise)(unit);
}

FactorUncertainty factor_uncertainty(Assessment const& assessment, std::uint64_t seed)
{
    UnitCube const& cube = assessment.cube();
    int const k = cube.size(), free = static_cast<int>(cube.free_factors().size());
    FactorUncertainty result;
    result.estimate = estimate(assessment);
    result.fit = goodness_of_fit(result.estimate.chi_square, assessment.objective().size(), free);
    result.target_noise = result.fit.inflation * result.estimate.noise;
    ChiSquare const chi_square(assessment, result.target_noise);
    VectorXd const& best = result.estimate.unit;
    auto const draws = draw(assessment, chi_square, best, RandomStream(derive_seed(seed, 1)));
    double const least = chi_square(best);
    result.region_95 = least + threshold_95;
    result.region_90 = least + chi_square_quantile(0.9, free);

    MatrixXd values(static_cast<Eigen::Index>(draws.size()), k);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        values.row(i) = cube.to_values(draws[i].unit).transpose();
    MatrixXd const centred = values.rowwise() - values.colwise().mean();
    constexpr Eigen::Index most_draws = 400;
    auto const stride = std::max<Eigen::Index>(1, values.rows() / most_draws);
    result.draws.resize((values.rows() + stride - 1) / stride, k);
    for (Eigen::Index i = 0; i < result.draws.rows(); ++i)
        result.draws.row(i) = draws[static_cast<std::size_t>(i * stride)].unit.transpose();
    result.standard_errors = (centred.cwiseAbs2().colwise().mean()).cwiseSqrt().transpose();
    result.correlations = correlation(values);

    Feasibility const feasibility(assessment.locations());
    SimulatedExtent const simulated(assessment);
    bool const is_missed = misses_targets(result.fit.p_value), is_simulated = simulated.holds(best);
    RandomStream random(derive_seed(seed, 2));
    MatrixXd extents(k, 2);
    result.spreads = VectorXd::Constant(k, std::numeric_limits<double>::quiet_NaN());
    for (int j = 0; j < k; ++j) {
        auto const evidence = evidence_on(assessment, chi_square, best, draws, j, random);
        extents.row(j) << evidence.lower.point[j], evidence.upper.point[j];
        if (!cube.is_free(j)) {
            result.verdicts.push_back(Verdict::fixed);
            result.on_bounds.push_back(OnBound::none);
            continue;
        }
        bool const by_extrapolation =
            !is_simulated || (determines(evidence.verdict()) &&
                              !(simulated.holds(j, extents(j, 0)) && simulated.holds(j, extents(j, 1))));
        auto const verdict = is_missed                                        ? Verdict::misfit
                             : rests_on_failures(feasibility, best, evidence) ? Verdict::extrapolated
                             : by_extrapolation                               ? Verdict::beyond_runs
                                                                              : evidence.verdict();
        if (double const spread = evidence.spread(); std::isfinite(spread) && has_interval(verdict))
            result.spreads[j] = spread;
        result.on_bounds.push_back(evidence.on_bound());
        result.verdicts.push_back(verdict);
    }
    result.intervals.resize(k, 2);
    result.intervals.col(0) = cube.to_values(extents.col(0));
    result.intervals.col(1) = cube.to_values(extents.col(1));
    for (int j = 0; j < k; ++j)
        if (!has_interval(result.verdicts[static_cast<std::size_t>(j)])) {
            result.intervals.row(j).setConstant(std::numeric_limits<double>::quiet_NaN());
            result.standard_errors[j] = std::numeric_limits<double>::quiet_NaN();
        }
    result.has_support = is_missed || (is_simulated && feasibility.chance(best) >= even);
    return result;
}

} // namespace demens::tao_calib
