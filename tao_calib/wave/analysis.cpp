#include "tao_calib/wave/analysis.hpp"

#include "tao_calib/wave/analysis_arrays.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ensemble::NamedArray;

constexpr int slice_points = 41;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double leave_one_out_r2(Samples const& samples, double rmse)
{
    double const mean = samples.weights.dot(samples.values) / samples.weights.sum();
    double const variance =
        samples.weights.dot((samples.values.array() - mean).square().matrix()) / samples.weights.sum();
    return variance > 0 ? 1 - rmse * rmse / variance : unknown;
}

void add_surrogates(Arrays& arrays, Assessment const& assessment)
{
    int const m = assessment.objective().size();
    VectorXd kind(m), rmse(m), r2(m), smoothing(m);
    for (int t = 0; t < m; ++t) {
        auto const& surrogate = assessment.surrogate(t);
        kind[t] = static_cast<int>(surrogate.kind());
        rmse[t] = leave_one_out_rmse(surrogate, assessment.samples(t));
        r2[t] = leave_one_out_r2(assessment.samples(t), rmse[t]);
        smoothing[t] = surrogate.smoothing();
    }
    arrays.number("surrogate/locations", assessment.locations().complete(), "1",
                  "locations the surrogates were fitted to");
    arrays.vector(
        "surrogate/kind", kind, "1",
        "by target: 0 constant, 1 linear, 2 linear and squares, 3 full quadratic, 4 cubic radial basis "
        "functions, 5 Gaussian process");
    arrays.vector("surrogate/leave_one_out_rmse", rmse, "mixed",
                  "by target, in its unit: root mean square error of predicting a location from the others");
    arrays.vector("surrogate/leave_one_out_r2", r2, "1",
                  "by target: 1 - mean square leave-one-out error/variance of the response");
    arrays.vector("surrogate/smoothing", smoothing, "1",
                  "by target: smoothing of the radial basis functions, 0 interpolates, NaN for other kinds");
    arrays.vector(
        "surrogate/replicate_sd", assessment.locations().replicate_sd(), "mixed",
        "by target, in its unit: standard deviation between runs at one location, NaN without repetitions");
}

void add_slices(Arrays& arrays, Assessment const& assessment)
{
    int const m = assessment.objective().size(), k = assessment.cube().size();
    auto const size = static_cast<std::size_t>(m) * k * slice_points;
    std::vector<std::size_t> const shape{static_cast<std::size_t>(m), static_cast<std::size_t>(k),
                                         slice_points};
    NamedArray values{
        "surrogate/slices", shape, std::vector<double>(size), "mixed",
        "target x factor x grid value, in the target's unit: predicted response along a factor through "
        "optimum/predicted_point"};
    NamedArray deviations{
        "surrogate/slice_sd", shape, std::vector<double>(size), "mixed",
        "target x factor x grid value, in the target's unit: standard deviation of the slices"};
    MatrixXd grid(k, slice_points);
    for (int j = 0; j < k; ++j)
        for (int g = 0; g < slice_points; ++g) {
            VectorXd unit = assessment.minima().front().point;
            unit[j] = static_cast<double>(g) / (slice_points - 1);
            grid(j, g) = assessment.cube().to_values(unit)[j];
            VectorXd const predicted = assessment.predict(unit), sd = assessment.prediction_sd(unit);
            for (int t = 0; t < m; ++t) {
                std::size_t const place = (static_cast<std::size_t>(t) * k + j) * slice_points + g;
                values.data[place] = predicted[t];
                deviations.data[place] = sd[t];
            }
        }
    arrays.matrix("surrogate/slice_values", grid, "mixed", "factor x grid value, in the factor's unit");
    arrays.add(std::move(values));
    arrays.add(std::move(deviations));
}

void add_best(Arrays& arrays, Objective const& objective, Location const& best)
{
    arrays.vector("optimum/best_point", best.factors, "mixed",
                  "by factor, in its unit: simulated location with the lowest weighted mean square error");
    arrays.number("optimum/best_point_number", best.points.front(), "1", "first design point there");
    arrays.number("optimum/best_run", best.first_finished_run, "1", "first finished run there");
    arrays.number("optimum/best_repetitions", static_cast<double>(best.points.size()), "1",
                  "design points simulated there; 1: not confirmed yet");
    arrays.vector("optimum/best_responses", best.responses, "mixed",
                  "by target, in its unit: simulated there, means over all runs");
    arrays.vector("optimum/best_residuals", objective.residuals(best.responses), "1",
                  "by target: (simulated - target)/scale there");
    arrays.number("optimum/wmse", objective.wmse(best.responses), "mixed",
                  "weighted mean square error there, over all targets of all experiments");
    arrays.number("optimum/mean_square_residual", objective.mean_square_residual(best.responses), "1",
                  "mean of ((simulated - target)/scale)^2 there");
    arrays.number("optimum/objective", objective.value(best.responses), "mixed",
                  "what [objective] asks to be minimised, there");
}

void add_prediction(Arrays& arrays, Assessment const& assessment)
{
    auto const& minimum = assessment.minima().front();
    arrays.vector("optimum/predicted_point", assessment.cube().to_values(minimum.point), "mixed",
                  "by factor, in its unit: minimum of the weighted mean square error on the surrogates");
    arrays.vector("optimum/predicted_responses", assessment.predict(minimum.point), "mixed",
                  "by target, in its unit: predicted there");
    arrays.vector("optimum/predicted_sd", assessment.prediction_sd(minimum.point), "mixed",
                  "by target, in its unit: standard deviation of the prediction there");
    arrays.number("optimum/predicted_wmse", assessment.objective().wmse(assessment.predict(minimum.point)),
                  "mixed", "predicted weighted mean square error there");
}

//! WMSE of each design point by itself, NaN where a target has no value.
VectorXd point_errors(ensemble::Campaign const& campaign, Objective const& objective, UnitCube const& cube)
{
    std::vector<Locations> points;
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            while (static_cast<int>(points.size()) <= run.point)
                points.emplace_back(objective, cube);
            points[run.point].add(run);
        }
    VectorXd errors = VectorXd::Constant(static_cast<Eigen::Index>(points.size()), unknown);
    for (std::size_t p = 0; p < points.size(); ++p)
        if (auto const* location = points[p].best())
            errors[static_cast<Eigen::Index>(p)] = objective.wmse(location->responses);
    return errors;
}

void add_history(Arrays& arrays, ensemble::Campaign const& campaign, Assessment const& assessment)
{
    auto const& objective = assessment.objective();
    std::vector<double> errors;
    Locations known(objective, assessment.cube());
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            known.add(run);
            auto const* best = known.best();
            errors.push_back(best ? objective.wmse(best->responses) : unknown);
        }
    arrays.vector("history/wmse",
                  Eigen::Map<VectorXd const>(errors.data(), static_cast<Eigen::Index>(errors.size())),
                  "mixed", "by run: weighted mean square error of the best location as known after it");
    arrays.vector("history/point_wmse", point_errors(campaign, objective, assessment.cube()), "mixed",
                  "by design point: its own weighted mean square error, NaN where a run failed");
}

} // namespace

std::vector<NamedArray> analysis_arrays(ensemble::Campaign const& campaign, Assessment const& assessment)
{
    Arrays arrays;
    if (has_screening(campaign.input))
        add_screening(arrays, assessment.screening());
    if (auto const* best = assessment.locations().best())
        add_best(arrays, assessment.objective(), *best);
    if (assessment.fitted()) {
        add_surrogates(arrays, assessment);
        add_slices(arrays, assessment);
        add_prediction(arrays, assessment);
        add_knowledge(arrays, campaign, assessment);
    }
    add_history(arrays, campaign, assessment);
    return arrays.take();
}

} // namespace demens::tao_calib
