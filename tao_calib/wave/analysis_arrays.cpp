#include "tao_calib/wave/analysis_arrays.hpp"

#include "tao_calib/wave/tolerance_region.hpp"
#include "tao_calib/wave/tradeoff.hpp"

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
namespace stored = ensemble::stored;

constexpr std::uint64_t uncertainty_stream = 0x756e636572; // "uncer"

//! The estimate and how well it meets the targets: what all intervals rest on. Unknown where no run supports
//! it.
void add_estimate(Arrays& arrays, Assessment const& assessment, FactorUncertainty const& known)
{
    VectorXd const& unit = known.estimate.unit;
    double const stated = known.has_support ? 1 : std::numeric_limits<double>::quiet_NaN();
    arrays.vector(stored::optimum::estimate, stated * assessment.cube().to_values(unit));
    arrays.vector(stored::optimum::estimate_responses, stated * assessment.predict(unit));
    arrays.vector(stored::optimum::estimate_sd, stated * assessment.prediction_sd(unit));
    arrays.number(stored::optimum::least_misfit, stated * known.fit.chi_square);
    arrays.number(stored::optimum::degrees, known.fit.degrees);
    arrays.number(stored::optimum::p_value, stated * known.fit.p_value);
    arrays.number(stored::optimum::noise_inflation, known.fit.inflation);
}

void add_uncertainty(Arrays& arrays, Assessment const& assessment, FactorUncertainty const& known)
{
    VectorXd verdicts(assessment.cube().size()), bounds(assessment.cube().size());
    for (Eigen::Index j = 0; j < verdicts.size(); ++j) {
        verdicts[j] = static_cast<int>(known.verdicts[static_cast<std::size_t>(j)]);
        bounds[j] = static_cast<int>(known.on_bounds[static_cast<std::size_t>(j)]);
    }
    arrays.vector(stored::optimum::target_noise, known.target_noise);
    arrays.vector(stored::optimum::factor_standard_error, known.standard_errors);
    arrays.matrix(stored::optimum::factor_interval, known.intervals);
    arrays.matrix(stored::optimum::factor_correlation, known.correlations);
    arrays.vector(stored::optimum::factor_verdict, verdicts);
    arrays.vector(stored::optimum::factor_spread, known.spreads);
    arrays.vector(stored::optimum::factor_on_bound, bounds);
    arrays.number(stored::optimum::region_90, known.region_90);
}

//! Draws evenly taken from all of them, which hang together in the order they were made.
void add_sets(Arrays& arrays, UnitCube const& cube, MatrixXd const& draws)
{
    constexpr Eigen::Index most_sets = 200;
    Eigen::Index const count = std::min(most_sets, draws.rows());
    MatrixXd sets(count, cube.size());
    for (Eigen::Index i = 0; i < count; ++i)
        sets.row(i) = cube.to_values(draws.row(i * draws.rows() / count).transpose()).transpose();
    arrays.matrix(stored::optimum::sets, sets);
}

void add_region(Arrays& arrays, UnitCube const& cube, ToleranceRegion const& region)
{
    arrays.number(stored::region::by_tolerance, region.by_tolerance);
    arrays.number(stored::region::share, region.share);
    auto const parts = static_cast<Eigen::Index>(region.parts.size());
    if (parts == 0)
        return;
    MatrixXd lower(parts, cube.size()), upper(parts, cube.size());
    VectorXd shares(parts);
    for (Eigen::Index p = 0; p < parts; ++p) {
        auto const& part = region.parts[static_cast<std::size_t>(p)];
        lower.row(p) = part.lower.transpose();
        upper.row(p) = part.upper.transpose();
        shares[p] = part.share;
    }
    arrays.vector(stored::region::part_shares, shares);
    arrays.matrix(stored::region::part_lower, lower);
    arrays.matrix(stored::region::part_upper, upper);
}

void add_tradeoffs(Arrays& arrays, std::vector<Tradeoff> const& pairs)
{
    if (pairs.empty())
        return;
    auto const count = static_cast<Eigen::Index>(pairs.size());
    MatrixXd factors(count, 2), responses(count, 2);
    VectorXd correlations(count), removed(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        auto const& pair = pairs[static_cast<std::size_t>(i)];
        factors.row(i) << pair.first, pair.second;
        responses.row(i) << pair.experiment, pair.response;
        correlations[i] = pair.correlation;
        removed[i] = pair.variance_removed;
    }
    arrays.matrix(stored::tradeoff::factors, factors);
    arrays.vector(stored::tradeoff::correlation, correlations);
    arrays.matrix(stored::tradeoff::response, responses);
    arrays.vector(stored::tradeoff::variance_removed, removed);
}

//! How far each target lies outside the means of all points, 0 where it is among them.
VectorXd out_of_reach(Assessment const& assessment)
{
    VectorXd distances = VectorXd::Zero(assessment.objective().size());
    for (int t = 0; t < distances.size(); ++t) {
        double const target = assessment.objective().targets()[t].target.value;
        auto const& values = assessment.samples(t).values;
        if (target > values.maxCoeff())
            distances[t] = target - values.maxCoeff();
        if (target < values.minCoeff())
            distances[t] = target - values.minCoeff();
    }
    return distances;
}

} // namespace

void add_knowledge(Arrays& arrays, ensemble::Campaign const& campaign, Assessment const& assessment)
{
    auto const seed =
        derive_seed(derive_seed(campaign.input.seed, uncertainty_stream), campaign.waves.size());
    auto const known = factor_uncertainty(assessment, seed);
    add_estimate(arrays, assessment, known);
    add_uncertainty(arrays, assessment, known);
    if (known.has_support) {
        add_sets(arrays, assessment.cube(), known.draws);
        add_region(arrays, assessment.cube(), tolerance_region(assessment, known, derive_seed(seed, 3)));
        add_tradeoffs(arrays, tradeoffs(campaign, assessment, known));
    }
    arrays.vector(stored::optimum::out_of_reach, out_of_reach(assessment));
}

void add_screening(Arrays& arrays, Screening const& screening)
{
    VectorXd active(static_cast<Eigen::Index>(screening.active.size()));
    for (Eigen::Index f = 0; f < active.size(); ++f)
        active[f] = screening.active[static_cast<std::size_t>(f)];
    arrays.vector(stored::screening::active, active);
    VectorXd curved(static_cast<Eigen::Index>(screening.curved.size()));
    for (Eigen::Index t = 0; t < curved.size(); ++t)
        curved[t] = screening.curved[static_cast<std::size_t>(t)];
    arrays.vector(stored::screening::curvature, screening.curvature);
    arrays.vector(stored::screening::curvature_p, screening.curvature_p);
    arrays.vector(stored::screening::curved, curved);
    arrays.vector(stored::screening::fixed_value, screening.fixed_values);
    arrays.matrix(stored::screening::effects, screening.effects);
    arrays.matrix(stored::screening::p_values, screening.p_values);
    arrays.vector(stored::screening::error_sd, screening.error_sd);
    arrays.vector(stored::screening::error_degrees, screening.error_degrees);
    arrays.number(stored::screening::error_from_replicates, screening.from_replicates);
}

} // namespace demens::tao_calib
