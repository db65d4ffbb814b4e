#include "tao_calib/wave/analysis.hpp"

#include "demens/base/not_a_number.hpp"
#include "tao_calib/wave/analysis_arrays.hpp"

#include <cmath>
#include <string>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ensemble::NamedArray;
namespace stored = ensemble::stored;

constexpr int slice_points = 41;
void add_surrogates(Arrays& arrays, Assessment const& assessment)
{
    int const m = assessment.objective().size();
    VectorXd kind(m), rmse(m), r2(m), smoothing(m), used(m);
    for (int t = 0; t < m; ++t) {
        auto const& surrogate = assessment.surrogate(t);
        kind[t] = static_cast<int>(surrogate.kind());
        rmse[t] = leave_one_out_rmse(surrogate, assessment.samples(t));
        r2[t] = assessment.leave_one_out_r2(t);
        used[t] = assessment.informs(t);
        smoothing[t] = surrogate.smoothing();
    }
    auto const& chosen = assessment.chosen_locations();
    int const complete = assessment.locations().complete();
    arrays.number(stored::surrogate::locations,
                  chosen.empty() ? complete : static_cast<double>(chosen.size()));
    arrays.number(stored::surrogate::complete_locations, complete);
    arrays.vector(stored::surrogate::kind, kind);
    arrays.vector(stored::surrogate::leave_one_out_rmse, rmse);
    arrays.vector(stored::surrogate::leave_one_out_r2, r2);
    arrays.vector(stored::surrogate::informs, used);
    arrays.vector(stored::surrogate::smoothing, smoothing);
    arrays.vector(stored::surrogate::replicate_sd, assessment.locations().replicate_sd());
}

//! What each surrogate says of locations that it does not know.
void add_cross_validation(Arrays& arrays, Assessment const& assessment)
{
    int const m = assessment.objective().size();
    Eigen::Index rows = 0;
    for (int t = 0; t < m; ++t)
        rows += assessment.samples(t).values.size();
    MatrixXd table(rows, 3);
    Eigen::Index first = 0;
    for (int t = 0; t < m; ++t) {
        auto const& simulated = assessment.samples(t).values;
        auto part = table.middleRows(first, simulated.size());
        part.col(0).setConstant(t);
        part.col(1) = simulated;
        part.col(2) = simulated - assessment.surrogate(t).leave_one_out_errors();
        first += simulated.size();
    }
    arrays.matrix(stored::surrogate::left_out, table);
}

void add_slices(Arrays& arrays, Assessment const& assessment)
{
    int const m = assessment.objective().size(), k = assessment.cube().size();
    std::vector<std::size_t> const shape{static_cast<std::size_t>(m), static_cast<std::size_t>(k),
                                         slice_points};
    NamedArray values = array_of(stored::surrogate::slices, shape);
    NamedArray deviations = array_of(stored::surrogate::slice_sd, shape);
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
    arrays.matrix(stored::surrogate::slice_values, grid);
    arrays.add(std::move(values));
    arrays.add(std::move(deviations));
}

void add_best(Arrays& arrays, Objective const& objective, Location const& best)
{
    arrays.vector(stored::optimum::best_point, best.factors);
    arrays.number(stored::optimum::best_point_number, best.points.front());
    arrays.number(stored::optimum::best_run, best.first_finished_run);
    arrays.number(stored::optimum::best_repetitions, static_cast<double>(best.points.size()));
    arrays.vector(stored::optimum::best_responses, best.responses);
    arrays.vector(stored::optimum::best_residuals, objective.residuals(best.responses));
    arrays.number(stored::optimum::wmse, objective.wmse(best.responses));
    arrays.number(stored::optimum::mean_square_residual, objective.mean_square_residual(best.responses));
    arrays.number(stored::optimum::objective, objective.value(best.responses));
}

void add_prediction(Arrays& arrays, Assessment const& assessment)
{
    auto const& minimum = assessment.minima().front();
    arrays.vector(stored::optimum::predicted_point, assessment.cube().to_values(minimum.point));
    arrays.vector(stored::optimum::predicted_responses, assessment.predict(minimum.point));
    arrays.vector(stored::optimum::predicted_sd, assessment.prediction_sd(minimum.point));
    arrays.number(stored::optimum::predicted_wmse,
                  assessment.objective().wmse(assessment.predict(minimum.point)));
}

//! The best location as known after each run, without a look at all locations for each.
class BestSoFar
{
  public:
    BestSoFar(Objective const& objective, UnitCube const& cube)
        : objective_(objective), known_(objective, cube)
    {
    }
    //! The least objective's location after one more run, or null.
    Location const* add(ensemble::RunRecord const& run)
    {
        Location const& changed = known_.add(run);
        auto const number = &changed - known_.all().data();
        double const value = changed.complete() ? objective_.value(changed.responses) : not_a_number;
        if (number == best_ && !(value <= least_)) { // a repetition has made the best one worse
            auto const* best = known_.best();
            best_ = best ? best - known_.all().data() : -1;
            least_ = best ? objective_.value(best->responses) : not_a_number;
        } else if (changed.complete() && (best_ < 0 || value < least_ || (value == least_ && number < best_)))
            best_ = number, least_ = value;
        return best_ < 0 ? nullptr : &known_.all()[static_cast<std::size_t>(best_)];
    }

  private:
    Objective const& objective_;
    Locations known_;
    std::ptrdiff_t best_ = -1; //!< number of the location
    double least_ = not_a_number;
};

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
    VectorXd errors = VectorXd::Constant(static_cast<Eigen::Index>(points.size()), not_a_number);
    for (std::size_t p = 0; p < points.size(); ++p)
        if (auto const* location = points[p].best())
            errors[static_cast<Eigen::Index>(p)] = objective.wmse(location->responses);
    return errors;
}

void add_history(Arrays& arrays, ensemble::Campaign const& campaign, Assessment const& assessment)
{
    auto const& objective = assessment.objective();
    std::vector<double> errors;
    BestSoFar best_so_far(objective, assessment.cube());
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            auto const* best = best_so_far.add(run);
            errors.push_back(best ? objective.wmse(best->responses) : not_a_number);
        }
    arrays.vector(stored::history::wmse,
                  Eigen::Map<VectorXd const>(errors.data(), static_cast<Eigen::Index>(errors.size())));
    arrays.vector(stored::history::point_wmse, point_errors(campaign, objective, assessment.cube()));
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
        add_cross_validation(arrays, assessment);
        add_slices(arrays, assessment);
        add_prediction(arrays, assessment);
        add_knowledge(arrays, campaign, assessment);
    }
    add_history(arrays, campaign, assessment);
    return arrays.take();
}

} // namespace demens::tao_calib
