#pragma once

#include <array>
#include <string_view>

//! The arrays that the calibration stores with a wave, one table a group: each name stands here and nowhere
//! else. ANALYSIS.md documents them for readers.
namespace demens::ensemble::stored {

//! How long an array is in a dimension.
enum class Extent
{
    none, //!< there is no such dimension
    any,
    one,
    two,
    factors,
    targets
};

//! What an array is called and what it holds.
struct ArrayName
{
    char const* path;  //!< below /waves/NNNN/
    char const* units; //!< "1" when dimensionless, "mixed" where entries differ
    char const* doc;   //!< one line
    std::array<Extent, 3> shape = {};
};

//! Best fit, prediction and what is known of each factor.
namespace optimum {
inline constexpr ArrayName best_point = {
    "optimum/best_point",
    "mixed",
    "by factor, in its unit: simulated location with the lowest weighted mean square error",
    {Extent::factors}};
inline constexpr ArrayName best_point_number = {
    "optimum/best_point_number", "1", "first design point there", {Extent::one}};
inline constexpr ArrayName best_run = {"optimum/best_run", "1", "first finished run there", {Extent::one}};
inline constexpr ArrayName best_repetitions = {
    "optimum/best_repetitions", "1", "design points simulated there; 1: not confirmed yet", {Extent::one}};
inline constexpr ArrayName best_responses = {"optimum/best_responses",
                                             "mixed",
                                             "by target, in its unit: simulated there, means over all runs",
                                             {Extent::targets}};
inline constexpr ArrayName best_residuals = {
    "optimum/best_residuals", "1", "by target: (simulated - target)/scale there", {Extent::targets}};
inline constexpr ArrayName wmse = {"optimum/wmse",
                                   "mixed",
                                   "weighted mean square error there, over all targets of all experiments",
                                   {Extent::one}};
inline constexpr ArrayName mean_square_residual = {
    "optimum/mean_square_residual", "1", "mean of ((simulated - target)/scale)^2 there", {Extent::one}};
inline constexpr ArrayName objective = {
    "optimum/objective", "mixed", "what [objective] asks to be minimised, there", {Extent::one}};
inline constexpr ArrayName predicted_point = {
    "optimum/predicted_point",
    "mixed",
    "by factor, in its unit: minimum of the weighted mean square error on the surrogates",
    {Extent::factors}};
inline constexpr ArrayName predicted_responses = {
    "optimum/predicted_responses", "mixed", "by target, in its unit: predicted there", {Extent::targets}};
inline constexpr ArrayName predicted_sd = {
    "optimum/predicted_sd",
    "mixed",
    "by target, in its unit: standard deviation of the prediction there",
    {Extent::targets}};
inline constexpr ArrayName predicted_wmse = {
    "optimum/predicted_wmse", "mixed", "predicted weighted mean square error there", {Extent::one}};
inline constexpr ArrayName estimate = {
    "optimum/estimate",
    "mixed",
    "by factor, in its unit: where the surrogates meet the targets best, deviations over their noise",
    {Extent::factors}};
inline constexpr ArrayName estimate_responses = {
    "optimum/estimate_responses", "mixed", "by target, in its unit: predicted there", {Extent::targets}};
inline constexpr ArrayName estimate_sd = {"optimum/estimate_sd",
                                          "mixed",
                                          "by target, in its unit: standard deviation of that prediction",
                                          {Extent::targets}};
inline constexpr ArrayName least_misfit = {
    "optimum/least_misfit", "1", "chi2 at the estimate, deviations over the noise as stated", {Extent::one}};
inline constexpr ArrayName degrees = {
    "optimum/degrees",
    "1",
    "degrees of freedom of least_misfit: targets - free factors, or the targets where that is none",
    {Extent::one}};
inline constexpr ArrayName p_value = {
    "optimum/p_value",
    "1",
    "probability of a misfit as large if responses, targets and their noise are as stated",
    {Extent::one}};
inline constexpr ArrayName noise_inflation = {
    "optimum/noise_inflation",
    "1",
    "factor by which the noise is enlarged for the intervals, 1: not",
    {Extent::one}};
inline constexpr ArrayName target_noise = {
    "optimum/target_noise",
    "mixed",
    "by target, in its unit: standard deviation used for the intervals, enlarged by noise_inflation",
    {Extent::targets}};
inline constexpr ArrayName factor_standard_error = {
    "optimum/factor_standard_error",
    "mixed",
    "by factor, in its unit: standard deviation over all parameter sets, weighted by likelihood",
    {Extent::factors}};
inline constexpr ArrayName factor_interval = {
    "optimum/factor_interval",
    "mixed",
    "factor x (lowest, highest), in its unit: values that can still meet the targets, 95 %",
    {Extent::factors, Extent::two}};
inline constexpr ArrayName factor_correlation = {"optimum/factor_correlation",
                                                 "1",
                                                 "factor x factor: correlation over the same parameter sets",
                                                 {Extent::factors, Extent::factors}};
inline constexpr ArrayName factor_verdict = {
    "optimum/factor_verdict",
    "1",
    "by factor: 0 determined, 1 weakly determined, 2 not determined by these targets, 3 fixed after "
    "screening, 4 the targets are missed, 5 extrapolated to where runs fail, 6 only a limit is known, 7 "
    "extrapolated beyond all runs",
    {Extent::factors}};
inline constexpr ArrayName factor_spread = {
    "optimum/factor_spread",
    "1",
    "by factor: half the interval over the estimate, the bounds left aside; logarithmic: the factor by which "
    "it is known, less 1; NaN: nothing limits it or its sign is open",
    {Extent::factors}};
inline constexpr ArrayName factor_on_bound = {
    "optimum/factor_on_bound",
    "1",
    "by factor: -1 the estimate is on the lower bound, 1 on the upper one, 0 on none",
    {Extent::factors}};
inline constexpr ArrayName sets = {"optimum/sets",
                                   "mixed",
                                   "parameter sets that the targets allow, drawn as often as they are likely",
                                   {Extent::any, Extent::factors}};
inline constexpr ArrayName region_90 = {
    "optimum/region_90",
    "1",
    "chi2, deviations over target_noise, up to which a set of all factors "
    "together is in the joint 90 % region",
    {Extent::one}};
inline constexpr ArrayName out_of_reach = {
    "optimum/out_of_reach",
    "mixed",
    "by target, in its unit: how far it lies beyond the means of all points; 0: among them",
    {Extent::targets}};
} // namespace optimum

//! What stands in for the simulation.
namespace surrogate {
inline constexpr ArrayName locations = {
    "surrogate/locations", "1", "locations the surrogates were fitted to", {Extent::one}};
inline constexpr ArrayName complete_locations = {
    "surrogate/complete_locations",
    "1",
    "locations with a value for every target; where there are many, surrogates are fitted to a part",
    {Extent::one}};
inline constexpr ArrayName informs = {
    "surrogate/informs",
    "1",
    "by target: 1 the surrogate is used for the intervals, 0 it predicts no better than the mean",
    {Extent::targets}};
inline constexpr ArrayName kind = {"surrogate/kind",
                                   "1",
                                   "by target: 0 constant, 1 linear, 2 linear and squares, 3 full quadratic, "
                                   "4 cubic radial basis functions, 5 Gaussian process",
                                   {Extent::targets}};
inline constexpr ArrayName leave_one_out_rmse = {
    "surrogate/leave_one_out_rmse",
    "mixed",
    "by target, in its unit: root mean square error of predicting a location from the others",
    {Extent::targets}};
inline constexpr ArrayName leave_one_out_r2 = {
    "surrogate/leave_one_out_r2",
    "1",
    "by target: 1 - mean square leave-one-out error/variance of the response",
    {Extent::targets}};
inline constexpr ArrayName left_out = {
    "surrogate/left_out",
    "mixed",
    "location x (target number, simulated there, predicted from the other locations), in the target's unit",
    {Extent::any, Extent::any}};
inline constexpr ArrayName smoothing = {
    "surrogate/smoothing",
    "1",
    "by target: smoothing of the radial basis functions, 0 interpolates, NaN for other kinds",
    {Extent::targets}};
inline constexpr ArrayName replicate_sd = {
    "surrogate/replicate_sd",
    "mixed",
    "by target, in its unit: standard deviation between runs at one location, NaN without repetitions",
    {Extent::targets}};
inline constexpr ArrayName slice_values = {"surrogate/slice_values",
                                           "mixed",
                                           "factor x grid value, in the factor's unit",
                                           {Extent::factors, Extent::any}};
inline constexpr ArrayName slices = {"surrogate/slices",
                                     "mixed",
                                     "target x factor x grid value, in the target's unit: predicted response "
                                     "along a factor through optimum/predicted_point",
                                     {Extent::targets, Extent::factors, Extent::any}};
inline constexpr ArrayName slice_sd = {
    "surrogate/slice_sd",
    "mixed",
    "target x factor x grid value, in the target's unit: standard deviation of the slices",
    {Extent::targets, Extent::factors, Extent::any}};
} // namespace surrogate

//! Where the targets can be met.
namespace region {
inline constexpr ArrayName by_tolerance = {
    "region/by_tolerance",
    "1",
    "1: where every target with a tolerance is predicted within it; 0: sets allowed at 95 %",
    {Extent::one}};
inline constexpr ArrayName share = {
    "region/share", "1", "of the feasible range of the factors", {Extent::one}};
inline constexpr ArrayName part_shares = {
    "region/part_shares", "1", "by part that hangs together: share of the sets found", {Extent::any}};
inline constexpr ArrayName part_lower = {"region/part_lower",
                                         "mixed",
                                         "part x factor, in its unit: lowest value found",
                                         {Extent::any, Extent::factors}};
inline constexpr ArrayName part_upper = {"region/part_upper",
                                         "mixed",
                                         "part x factor, in its unit: highest value found",
                                         {Extent::any, Extent::factors}};
} // namespace region

//! Factors that trade off.
namespace tradeoff {
inline constexpr ArrayName factors = {
    "tradeoff/factors", "1", "pair x 2: numbers of the factors that trade off", {Extent::any, Extent::two}};
inline constexpr ArrayName correlation = {
    "tradeoff/correlation", "1", "by pair: over the sets that the targets allow", {Extent::any}};
inline constexpr ArrayName response = {
    "tradeoff/response",
    "1",
    "pair x (experiment, response of its rig): what would separate them best; -1: nothing simulated",
    {Extent::any, Extent::two}};
inline constexpr ArrayName variance_removed = {
    "tradeoff/variance_removed",
    "1",
    "by pair: share of its variance that measuring that response would take away",
    {Extent::any}};
} // namespace tradeoff

//! Which factors act.
namespace screening {
inline constexpr ArrayName active = {
    "screening/active", "1", "by factor: 1 where some target's p value is small enough", {Extent::factors}};
inline constexpr ArrayName curvature = {
    "screening/curvature",
    "mixed",
    "by target, in its unit: response at the centre less what main effects "
    "make of the corners, NaN without centre points",
    {Extent::targets}};
inline constexpr ArrayName curvature_p = {"screening/curvature_p",
                                          "1",
                                          "by target: p value of no curvature, NaN where nothing tells",
                                          {Extent::targets}};
inline constexpr ArrayName curved = {
    "screening/curved",
    "1",
    "by target: 1 the curvature is beyond chance and its sd, so that no factor was fixed",
    {Extent::targets}};
inline constexpr ArrayName fixed_value = {
    "screening/fixed_value",
    "mixed",
    "by factor, in its unit: value kept from now on, NaN where it is free",
    {Extent::factors}};
inline constexpr ArrayName effects = {
    "screening/effects",
    "mixed",
    "target x factor, in the target's unit: change from the factor's lower to its upper bound",
    {Extent::targets, Extent::factors}};
inline constexpr ArrayName p_values = {
    "screening/p_values", "1", "target x factor: p value of that effect", {Extent::targets, Extent::factors}};
inline constexpr ArrayName error_sd = {
    "screening/error_sd",
    "mixed",
    "by target, in its unit: standard deviation of a run, against which effects were tested",
    {Extent::targets}};
inline constexpr ArrayName error_degrees = {
    "screening/error_degrees", "1", "by target: its degrees of freedom", {Extent::targets}};
inline constexpr ArrayName error_from_replicates = {
    "screening/error_from_replicates",
    "1",
    "1: that error is pure, from repeated runs; 0: what the main effects leave over",
    {Extent::one}};
} // namespace screening

//! How the campaign went.
namespace history {
inline constexpr ArrayName wmse = {
    "history/wmse",
    "mixed",
    "by run: weighted mean square error of the best location as known after it",
    {Extent::any}};
inline constexpr ArrayName point_wmse = {
    "history/point_wmse",
    "mixed",
    "by design point: its own weighted mean square error, NaN where a run failed",
    {Extent::any}};
} // namespace history

//! All of them.
inline constexpr std::array all_arrays = {&optimum::best_point,
                                          &optimum::best_point_number,
                                          &optimum::best_run,
                                          &optimum::best_repetitions,
                                          &optimum::best_responses,
                                          &optimum::best_residuals,
                                          &optimum::wmse,
                                          &optimum::mean_square_residual,
                                          &optimum::objective,
                                          &optimum::predicted_point,
                                          &optimum::predicted_responses,
                                          &optimum::predicted_sd,
                                          &optimum::predicted_wmse,
                                          &optimum::estimate,
                                          &optimum::estimate_responses,
                                          &optimum::estimate_sd,
                                          &optimum::least_misfit,
                                          &optimum::degrees,
                                          &optimum::p_value,
                                          &optimum::noise_inflation,
                                          &optimum::target_noise,
                                          &optimum::factor_standard_error,
                                          &optimum::factor_interval,
                                          &optimum::factor_correlation,
                                          &optimum::factor_verdict,
                                          &optimum::factor_spread,
                                          &optimum::factor_on_bound,
                                          &optimum::sets,
                                          &optimum::region_90,
                                          &optimum::out_of_reach,
                                          &surrogate::locations,
                                          &surrogate::complete_locations,
                                          &surrogate::informs,
                                          &surrogate::kind,
                                          &surrogate::leave_one_out_rmse,
                                          &surrogate::leave_one_out_r2,
                                          &surrogate::left_out,
                                          &surrogate::smoothing,
                                          &surrogate::replicate_sd,
                                          &surrogate::slice_values,
                                          &surrogate::slices,
                                          &surrogate::slice_sd,
                                          &region::by_tolerance,
                                          &region::share,
                                          &region::part_shares,
                                          &region::part_lower,
                                          &region::part_upper,
                                          &tradeoff::factors,
                                          &tradeoff::correlation,
                                          &tradeoff::response,
                                          &tradeoff::variance_removed,
                                          &screening::active,
                                          &screening::curvature,
                                          &screening::curvature_p,
                                          &screening::curved,
                                          &screening::fixed_value,
                                          &screening::effects,
                                          &screening::p_values,
                                          &screening::error_sd,
                                          &screening::error_degrees,
                                          &screening::error_from_replicates,
                                          &history::wmse,
                                          &history::point_wmse};

//! The name with that path, or null.
inline ArrayName const* find_name(std::string_view path)
{
    for (auto const* name : all_arrays)
        if (name->path == path)
            return name;
    return nullptr;
}

} // namespace demens::ensemble::stored
