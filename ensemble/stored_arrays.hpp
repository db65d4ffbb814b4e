#pragma once

//! The arrays that the calibration stores with a wave, one table a group: each name stands here and nowhere
//! else. ANALYSIS.md documents them for readers.
namespace demens::ensemble::stored {

//! What an array is called and what it holds.
struct ArrayName
{
    char const* path;  //!< below /waves/NNNN/
    char const* units; //!< "1" when dimensionless, "mixed" where entries differ
    char const* doc;   //!< one line
};

//! Best fit, prediction and what is known of each factor.
namespace optimum {
inline constexpr ArrayName best_point = {
    "optimum/best_point", "mixed",
    "by factor, in its unit: simulated location with the lowest weighted mean square error"};
inline constexpr ArrayName best_point_number = {"optimum/best_point_number", "1", "first design point there"};
inline constexpr ArrayName best_run = {"optimum/best_run", "1", "first finished run there"};
inline constexpr ArrayName best_repetitions = {"optimum/best_repetitions", "1",
                                               "design points simulated there; 1: not confirmed yet"};
inline constexpr ArrayName best_responses = {"optimum/best_responses", "mixed",
                                             "by target, in its unit: simulated there, means over all runs"};
inline constexpr ArrayName best_residuals = {"optimum/best_residuals", "1",
                                             "by target: (simulated - target)/scale there"};
inline constexpr ArrayName wmse = {"optimum/wmse", "mixed",
                                   "weighted mean square error there, over all targets of all experiments"};
inline constexpr ArrayName mean_square_residual = {"optimum/mean_square_residual", "1",
                                                   "mean of ((simulated - target)/scale)^2 there"};
inline constexpr ArrayName objective = {"optimum/objective", "mixed",
                                        "what [objective] asks to be minimised, there"};
inline constexpr ArrayName predicted_point = {
    "optimum/predicted_point", "mixed",
    "by factor, in its unit: minimum of the weighted mean square error on the surrogates"};
inline constexpr ArrayName predicted_responses = {"optimum/predicted_responses", "mixed",
                                                  "by target, in its unit: predicted there"};
inline constexpr ArrayName predicted_sd = {
    "optimum/predicted_sd", "mixed", "by target, in its unit: standard deviation of the prediction there"};
inline constexpr ArrayName predicted_wmse = {"optimum/predicted_wmse", "mixed",
                                             "predicted weighted mean square error there"};
inline constexpr ArrayName estimate = {
    "optimum/estimate", "mixed",
    "by factor, in its unit: where the surrogates meet the targets best, deviations over their noise"};
inline constexpr ArrayName estimate_responses = {"optimum/estimate_responses", "mixed",
                                                 "by target, in its unit: predicted there"};
inline constexpr ArrayName estimate_sd = {"optimum/estimate_sd", "mixed",
                                          "by target, in its unit: standard deviation of that prediction"};
inline constexpr ArrayName least_misfit = {"optimum/least_misfit", "1",
                                           "chi2 at the estimate, deviations over the noise as stated"};
inline constexpr ArrayName degrees = {
    "optimum/degrees", "1",
    "degrees of freedom of least_misfit: targets - free factors, or the targets where that is none"};
inline constexpr ArrayName p_value = {
    "optimum/p_value", "1",
    "probability of a misfit as large if responses, targets and their noise are as stated"};
inline constexpr ArrayName noise_inflation = {
    "optimum/noise_inflation", "1", "factor by which the noise is enlarged for the intervals, 1: not"};
inline constexpr ArrayName target_noise = {
    "optimum/target_noise", "mixed",
    "by target, in its unit: standard deviation used for the intervals, enlarged by noise_inflation"};
inline constexpr ArrayName factor_standard_error = {
    "optimum/factor_standard_error", "mixed",
    "by factor, in its unit: standard deviation over all parameter sets, weighted by likelihood"};
inline constexpr ArrayName factor_interval = {
    "optimum/factor_interval", "mixed",
    "factor x (lowest, highest), in its unit: values that can still meet the targets, 95 %"};
inline constexpr ArrayName factor_correlation = {"optimum/factor_correlation", "1",
                                                 "factor x factor: correlation over the same parameter sets"};
inline constexpr ArrayName factor_verdict = {
    "optimum/factor_verdict", "1",
    "by factor: 0 determined, 1 weakly determined, 2 not determined by these targets, 3 fixed after "
    "screening, 4 the targets are missed, 5 extrapolated to where runs fail, 6 only a limit is known"};
inline constexpr ArrayName factor_spread = {
    "optimum/factor_spread", "1",
    "by factor: half the interval over the estimate, the bounds left aside; logarithmic: the factor by which "
    "it is known, less 1; NaN: nothing limits it or its sign is open"};
inline constexpr ArrayName factor_on_bound = {
    "optimum/factor_on_bound", "1",
    "by factor: -1 the estimate is on the lower bound, 1 on the upper one, 0 on none"};
inline constexpr ArrayName region_90 = {
    "optimum/region_90", "1",
    "chi2, deviations over target_noise, up to which a set of all factors "
    "together is in the joint 90 % region"};
inline constexpr ArrayName out_of_reach = {
    "optimum/out_of_reach", "mixed",
    "by target, in its unit: how far it lies beyond what any run gave; 0: among them"};
} // namespace optimum

//! What stands in for the simulation.
namespace surrogate {
inline constexpr ArrayName locations = {"surrogate/locations", "1",
                                        "locations the surrogates were fitted to"};
inline constexpr ArrayName complete_locations = {
    "surrogate/complete_locations", "1",
    "locations with a value for every target; where there are many, surrogates are fitted to a part"};
inline constexpr ArrayName informs = {
    "surrogate/informs", "1",
    "by target: 1 the surrogate is used for the intervals, 0 it predicts no better than the mean"};
inline constexpr ArrayName kind = {"surrogate/kind", "1",
                                   "by target: 0 constant, 1 linear, 2 linear and squares, 3 full quadratic, "
                                   "4 cubic radial basis functions, 5 Gaussian process"};
inline constexpr ArrayName leave_one_out_rmse = {
    "surrogate/leave_one_out_rmse", "mixed",
    "by target, in its unit: root mean square error of predicting a location from the others"};
inline constexpr ArrayName leave_one_out_r2 = {
    "surrogate/leave_one_out_r2", "1",
    "by target: 1 - mean square leave-one-out error/variance of the response"};
inline constexpr ArrayName smoothing = {
    "surrogate/smoothing", "1",
    "by target: smoothing of the radial basis functions, 0 interpolates, NaN for other kinds"};
inline constexpr ArrayName replicate_sd = {
    "surrogate/replicate_sd", "mixed",
    "by target, in its unit: standard deviation between runs at one location, NaN without repetitions"};
inline constexpr ArrayName slice_values = {"surrogate/slice_values", "mixed",
                                           "factor x grid value, in the factor's unit"};
inline constexpr ArrayName slices = {"surrogate/slices", "mixed",
                                     "target x factor x grid value, in the target's unit: predicted response "
                                     "along a factor through optimum/predicted_point"};
inline constexpr ArrayName slice_sd = {
    "surrogate/slice_sd", "mixed",
    "target x factor x grid value, in the target's unit: standard deviation of the slices"};
} // namespace surrogate

//! Where the targets can be met.
namespace region {
inline constexpr ArrayName by_tolerance = {
    "region/by_tolerance", "1",
    "1: where every target with a tolerance is predicted within it; 0: sets allowed at 95 %"};
inline constexpr ArrayName share = {"region/share", "1", "of the feasible range of the factors"};
inline constexpr ArrayName part_shares = {"region/part_shares", "1",
                                          "by part that hangs together: share of the sets found"};
inline constexpr ArrayName part_lower = {"region/part_lower", "mixed",
                                         "part x factor, in its unit: lowest value found"};
inline constexpr ArrayName part_upper = {"region/part_upper", "mixed",
                                         "part x factor, in its unit: highest value found"};
} // namespace region

//! Factors that trade off.
namespace tradeoff {
inline constexpr ArrayName factors = {"tradeoff/factors", "1",
                                      "pair x 2: numbers of the factors that trade off"};
inline constexpr ArrayName correlation = {"tradeoff/correlation", "1",
                                          "by pair: over the sets that the targets allow"};
inline constexpr ArrayName response = {
    "tradeoff/response", "1",
    "pair x (experiment, response of its rig): what would separate them best; -1: nothing simulated"};
inline constexpr ArrayName variance_removed = {
    "tradeoff/variance_removed", "1",
    "by pair: share of its variance that measuring that response would take away"};
} // namespace tradeoff

//! Which factors act.
namespace screening {
inline constexpr ArrayName active = {"screening/active", "1",
                                     "by factor: 1 where some target's p value is small enough"};
inline constexpr ArrayName curvature = {
    "screening/curvature", "mixed",
    "by target, in its unit: response at the centre less what main effects "
    "make of the corners, NaN without centre points"};
inline constexpr ArrayName curvature_p = {"screening/curvature_p", "1",
                                          "by target: p value of no curvature, NaN where nothing tells"};
inline constexpr ArrayName curved = {
    "screening/curved", "1",
    "by target: 1 the curvature is beyond chance and its sd, so that no factor was fixed"};
inline constexpr ArrayName fixed_value = {
    "screening/fixed_value", "mixed", "by factor, in its unit: value kept from now on, NaN where it is free"};
inline constexpr ArrayName effects = {
    "screening/effects", "mixed",
    "target x factor, in the target's unit: change from the factor's lower to its upper bound"};
inline constexpr ArrayName p_values = {"screening/p_values", "1", "target x factor: p value of that effect"};
inline constexpr ArrayName error_sd = {
    "screening/error_sd", "mixed",
    "by target, in its unit: standard deviation of a run, against which effects were tested"};
inline constexpr ArrayName error_degrees = {"screening/error_degrees", "1",
                                            "by target: its degrees of freedom"};
inline constexpr ArrayName error_from_replicates = {
    "screening/error_from_replicates", "1",
    "1: that error is pure, from repeated runs; 0: what the main effects leave over"};
} // namespace screening

//! How the campaign went.
namespace history {
inline constexpr ArrayName wmse = {
    "history/wmse", "mixed", "by run: weighted mean square error of the best location as known after it"};
inline constexpr ArrayName point_wmse = {
    "history/point_wmse", "mixed",
    "by design point: its own weighted mean square error, NaN where a run failed"};
} // namespace history

} // namespace demens::ensemble::stored
