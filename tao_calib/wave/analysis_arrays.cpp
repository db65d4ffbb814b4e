#include "tao_calib/wave/analysis_arrays.hpp"

#include "tao_calib/wave/tolerance_region.hpp"
#include "tao_calib/wave/tradeoff.hpp"

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::uint64_t uncertainty_stream = 0x756e636572; // "uncer"

void add_uncertainty(Arrays& arrays, Assessment const& assessment, FactorUncertainty const& known)
{
    VectorXd verdicts(assessment.cube().size());
    for (Eigen::Index j = 0; j < verdicts.size(); ++j)
        verdicts[j] = static_cast<int>(known.verdicts[j]);
    arrays.vector("optimum/target_noise", known.target_noise, "mixed",
                  "by target, in its unit: standard deviation used for the intervals");
    arrays.vector(
        "optimum/factor_standard_error", known.standard_errors, "mixed",
        "by factor, in its unit: standard deviation over all parameter sets, weighted by likelihood");
    arrays.matrix("optimum/factor_interval", known.intervals, "mixed",
                  "factor x (lowest, highest), in its unit: values that can still meet the targets, 95 %");
    arrays.matrix("optimum/factor_correlation", known.correlations, "1",
                  "factor x factor: correlation over the same parameter sets");
    arrays.vector(
        "optimum/factor_verdict", verdicts, "1",
        "by factor: 0 determined, 1 weakly determined, 2 not determined by these targets, 3 fixed after "
        "screening");
    arrays.number("optimum/least_misfit", known.least_misfit, "1",
                  "chi2 of the predicted responses at the predicted optimum, deviations over target_noise");
    arrays.number("optimum/region_90", known.region_90, "1",
                  "chi2 up to which a set of all factors together is in the joint 90 % region");
}

void add_region(Arrays& arrays, UnitCube const& cube, ToleranceRegion const& region)
{
    arrays.number("region/by_tolerance", region.by_tolerance, "1",
                  "1: where every target with a tolerance is predicted within it; 0: sets allowed at 95 %");
    arrays.number("region/share", region.share, "1", "of the feasible range of the factors");
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
    arrays.vector("region/part_shares", shares, "1", "by part that hangs together: share of the sets found");
    arrays.matrix("region/part_lower", lower, "mixed", "part x factor, in its unit: lowest value found");
    arrays.matrix("region/part_upper", upper, "mixed", "part x factor, in its unit: highest value found");
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
    arrays.matrix("tradeoff/factors", factors, "1", "pair x 2: numbers of the factors that trade off");
    arrays.vector("tradeoff/correlation", correlations, "1", "by pair: over the sets that the targets allow");
    arrays.matrix(
        "tradeoff/response", responses, "1",
        "pair x (experiment, response of its rig): what would separate them best; -1: nothing simulated");
    arrays.vector("tradeoff/variance_removed", removed, "1",
                  "by pair: share of its variance that measuring that response would take away");
}

//! How far each target lies outside what all runs gave, 0 where it is among them.
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
    add_uncertainty(arrays, assessment, known);
    add_region(arrays, assessment.cube(), tolerance_region(assessment, known, derive_seed(seed, 3)));
    add_tradeoffs(arrays, tradeoffs(campaign, assessment, known));
    arrays.vector("optimum/out_of_reach", out_of_reach(assessment), "mixed",
                  "by target, in its unit: how far it lies beyond what any run gave; 0: among them");
}

void add_screening(Arrays& arrays, Screening const& screening)
{
    VectorXd active(static_cast<Eigen::Index>(screening.active.size()));
    for (Eigen::Index f = 0; f < active.size(); ++f)
        active[f] = screening.active[static_cast<std::size_t>(f)];
    arrays.vector("screening/active", active, "1",
                  "by factor: 1 where some target's p value is small enough");
    arrays.vector("screening/fixed_value", screening.fixed_values, "mixed",
                  "by factor, in its unit: value kept from now on, NaN where it is free");
    arrays.matrix("screening/effects", screening.effects, "mixed",
                  "target x factor, in the target's unit: change from the factor's lower to its upper bound");
    arrays.matrix("screening/p_values", screening.p_values, "1", "target x factor: p value of that effect");
    arrays.vector("screening/error_sd", screening.error_sd, "mixed",
                  "by target, in its unit: standard deviation of a run, against which effects were tested");
    arrays.vector("screening/error_degrees", screening.error_degrees, "1",
                  "by target: its degrees of freedom");
    arrays.number("screening/error_from_replicates", screening.from_replicates, "1",
                  "1: that error is pure, from repeated runs; 0: what the main effects leave over");
}

} // namespace demens::tao_calib
