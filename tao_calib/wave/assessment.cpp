#include "tao_calib/wave/assessment.hpp"

#include "tao_calib/wave/target_surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::uint64_t starts_stream = 0x737461727473; // "starts"
constexpr std::size_t starts_at_locations = 3;          // of the best simulated locations
constexpr double distinct_separation = 0.05;            // between minima, in shares of the ranges
//! Radial basis functions and Gaussian processes cost the third power of the locations: some seconds each
//! here.
constexpr int most_fitted_locations = 400;

double r2_of(Samples const& samples, Surrogate const& surrogate)
{
    double const mean = samples.weights.dot(samples.values) / samples.weights.sum();
    double const variance =
        samples.weights.dot((samples.values.array() - mean).square().matrix()) / samples.weights.sum();
    double const rounding = 1e-12 * samples.values.cwiseAbs().maxCoeff();
    if (!(variance > rounding * rounding))
        return std::numeric_limits<double>::quiet_NaN();
    return 1 - std::pow(leave_one_out_rmse(surrogate, samples), 2) / variance;
}

} // namespace

Assessment::Assessment(ensemble::Campaign const& campaign, LeastSquaresSolver const& solver)
    : solver_(solver), objective_(campaign.input), screening_(screen(campaign, objective_)),
      cube_(campaign.input.factors, campaign.input.constraints, screening_.fixed()),
      locations_(objective_, cube_, campaign)
{
    if (locations_.complete() < locations_needed(cube_.size()))
        return;
    if (campaign.input.surrogate.kind !=
        SurrogateChoice::quadratic) // the one kind whose cost grows with the runs alone
        chosen_ = locations_.best_and_spread(most_fitted_locations);
    for (int t = 0; t < objective_.size(); ++t) {
        samples_.push_back(locations_.samples(t, chosen_));
        surrogates_.push_back(
            fit_target(campaign.input.surrogate.kind, objective_.targets()[t].target, samples_.back()));
    }
    r2_.resize(objective_.size());
    for (int t = 0; t < objective_.size(); ++t)
        r2_[t] = r2_of(samples_[static_cast<std::size_t>(t)], *surrogates_[static_cast<std::size_t>(t)]);

    auto const ranked = locations_.ranked();
    std::vector<VectorXd> starts;
    for (std::size_t i = 0; i < std::min(ranked.size(), starts_at_locations); ++i)
        starts.push_back(ranked[i]->unit);
    auto const seed = derive_seed(derive_seed(campaign.input.seed, starts_stream), campaign.waves.size());
    auto const spread = spread_points(
        cube_, std::max(1, campaign.input.solver.starts - static_cast<int>(starts.size())), starts, seed);
    starts.insert(starts.end(), spread.begin(), spread.end());
    LeastSquaresProblem const problem{
        cube_.size(), objective_.residual_count(),
        [this](VectorXd const& unit) { return objective_.search_residuals(predict(unit)); },
        [this](VectorXd const& unit) {
            return MatrixXd(objective_.search_slopes(predict(unit)) * response_slopes(unit));
        }};
    minima_ = distinct_minima(solver, problem, cube_, starts, distinct_separation);
}

VectorXd Assessment::predict(VectorXd const& unit) const
{
    VectorXd responses(objective_.size());
    for (int t = 0; t < objective_.size(); ++t)
        responses[t] = surrogates_[t]->value(unit);
    return responses;
}

MatrixXd Assessment::response_slopes(VectorXd const& unit) const
{
    MatrixXd slopes(objective_.size(), unit.size());
    for (int t = 0; t < objective_.size(); ++t)
        slopes.row(t) = surrogates_[t]->gradient(unit).transpose();
    return slopes;
}

VectorXd Assessment::prediction_sd(VectorXd const& unit) const
{
    VectorXd deviations(objective_.size());
    for (int t = 0; t < objective_.size(); ++t)
        deviations[t] = surrogates_[t]->supported_deviation(unit);
    return deviations;
}

VectorXd Assessment::assumed_sd(VectorXd const& unit) const
{
    VectorXd deviations(objective_.size());
    for (int t = 0; t < objective_.size(); ++t)
        deviations[t] = surrogates_[t]->standard_deviation(unit);
    return deviations;
}

double Assessment::mean_response(int target) const
{
    auto const& samples = samples_[static_cast<std::size_t>(target)];
    return samples.weights.dot(samples.values) / samples.weights.sum();
}

} // namespace demens::tao_calib
