#include "gap/table/table_gap.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/floor.hpp"
#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/solver/polish.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using tao_calib::Levels;
using tao_calib::UnitCube;

constexpr double prior_variance = 1.0 / 12; //!< of a factor anywhere between its bounds, in the unit cube
constexpr int starts = 12;
constexpr double distinct = 0.05; //!< of minima, in the unit cube

//! The table as a function of the free factors, in the unit cube.
class Model
{
  public:
    explicit Model(MeasuredTable const& measured)
        : measured_(measured),
          cube_(measured.fit.free_space().factors(), measured.fit.free_space().constraints())
    {
    }

    UnitCube const& cube() const { return cube_; }
    //! All factors at a point.
    VectorXd values(VectorXd const& unit, Levels const& levels, MeasuredPoint const& point) const
    {
        VectorXd values = measured_.fit.space().all_values(cube_.to_values(unit), levels);
        for (int const k : measured_.conditions)
            values[k] = point.known[static_cast<std::size_t>(k)];
        return values;
    }
    VectorXd predicted(std::vector<TableCell> const& cells, VectorXd const& unit, Levels const& levels) const
    {
        return of_each(cells, unit, levels,
                       [](tao_calib::Regression const& regression, VectorXd const& coded) {
                           return regression.predict(coded);
                       });
    }
    //! Variance of the predicted means; 0 where the runs tell nothing of their scatter.
    VectorXd variances(std::vector<TableCell> const& cells, VectorXd const& unit, Levels const& levels) const
    {
        return of_each(cells, unit, levels,
                       [](tao_calib::Regression const& regression, VectorXd const& coded) {
                           return regression.scatter() == tao_calib::Scatter::known
                                      ? std::pow(regression.prediction_standard_error(coded), 2)
                                      : 0.0;
                       });
    }

  private:
    template <class Number>
    VectorXd of_each(std::vector<TableCell> const& cells, VectorXd const& unit, Levels const& levels,
                     Number const& number) const
    {
        VectorXd result(static_cast<Index>(cells.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            auto const [point, response] = cells[i];
            auto const all = values(unit, levels, measured_.points[static_cast<std::size_t>(point)]);
            result[static_cast<Index>(i)] =
                number(measured_.fit.fits()[static_cast<std::size_t>(response)].regression(),
                       measured_.fit.space().coded(all));
        }
        return result;
    }

    MeasuredTable const& measured_;
    UnitCube cube_;
};

//! A minimum of squares of deviations over their variances.
struct Minimum
{
    VectorXd unit;
    Levels levels;
    double misfit;
};

Minimum best_of(Model const& model, MeasuredTable const& measured, std::vector<TableCell> const& cells,
                VectorXd const& values, VectorXd const& deviations,
                tao_calib::LeastSquaresSolver const& solver)
{
    double unit = 1; // that makes no residual larger than in ranges of the responses
    for (std::size_t i = 0; i < cells.size(); ++i) {
        auto const& runs =
            measured.fit.fits()[static_cast<std::size_t>(cells[i].response)].regression().data().values;
        unit = std::min(unit, deviations[static_cast<Index>(i)] / (runs.maxCoeff() - runs.minCoeff()));
    }
    std::optional<Minimum> best;
    for (auto const& levels : measured.fit.space().choices()) {
        tao_calib::LeastSquaresProblem const problem{
            model.cube().size(), static_cast<int>(cells.size()), [&](VectorXd const& point) {
                return VectorXd(unit *
                                (model.predicted(cells, point, levels) - values).cwiseQuotient(deviations));
            }};
        auto const minima = distinct_minima(solver, problem, model.cube(),
                                            tao_calib::spread_points(model.cube(), starts, {}, 1), distinct);
        VectorXd const point = tao_calib::polished(problem, model.cube(), minima.front().point);
        double const misfit = problem.evaluate(point).squaredNorm() / (unit * unit);
        if (!best || misfit < best->misfit)
            best = Minimum{point, levels, misfit};
    }
    return best.value();
}

//! How cells change with the free factors.
Eigen::MatrixXd slopes(Model const& model, std::vector<TableCell> const& cells, Minimum const& about)
{
    return tao_calib::central_slopes(
        [&](VectorXd const& unit) { return model.predicted(cells, unit, about.levels); }, about.unit);
}

//! Conditions from 0 to 1.
std::vector<double> coordinates(MeasuredTable const& measured, MeasuredPoint const& point)
{
    std::vector<double> result;
    for (int const k : measured.conditions) {
        auto const& factor = measured.fit.input().factors[static_cast<std::size_t>(k)];
        double const value = point.known[static_cast<std::size_t>(k)];
        result.push_back(factor.kind == tao_calib::FactorKind::continuous
                             ? (value - factor.lower) / (factor.upper - factor.lower)
                             : value);
    }
    return result;
}

//! What was measured and can be predicted.
void list_cells(TableGap& gap, MeasuredTable const& measured)
{
    auto const& input = measured.fit.input();
    std::vector<double> values, variances;
    std::vector<bool> by_scale(input.responses.size(), false);
    for (std::size_t p = 0; p < measured.points.size(); ++p)
        for (std::size_t r = 0; r < input.responses.size(); ++r) {
            auto const& point = measured.points[p];
            double const value = point.values[static_cast<Index>(r)];
            if (std::isnan(value) || !measured.fit.fits()[r].reduced)
                continue;
            double sd = point.sd[static_cast<Index>(r)];
            if (std::isnan(sd)) {
                sd = input.responses[r].scale;
                by_scale[r] = true;
            }
            gap.cells.push_back({static_cast<int>(p), static_cast<int>(r)});
            gap.evidence.cells.push_back(
                {.name = fmt::format("{} at {}", input.responses[r].column, point.name),
                 .experiment = static_cast<int>(p),
                 .response_family = static_cast<int>(r),
                 .condition = coordinates(measured, point),
                 .scale = value != 0 ? std::abs(value) : sd});
            values.push_back(value), variances.push_back(sd * sd);
        }
    auto const count = static_cast<Index>(values.size());
    gap.evidence.measured = VectorXd::Map(values.data(), count);
    gap.evidence.experiment_variance = VectorXd::Map(variances.data(), count);
    for (std::size_t r = 0; r < by_scale.size(); ++r)
        if (by_scale[r])
            gap.assumed.push_back(
                fmt::format("a measured {} has a standard deviation of {:.4g}: its scale or tolerance, or, "
                            "without them, the scatter of the runs; a column `{}_sd` would say it",
                            input.responses[r].column, input.responses[r].scale, input.responses[r].column));
}

TableOptimum optimum_of(Model const& model, MeasuredPoint const& first, Minimum const& minimum,
                        Eigen::MatrixXd const& slope, VectorXd const& deviations)
{
    Eigen::MatrixXd const weighted = deviations.cwiseInverse().asDiagonal() * slope;
    auto const k = minimum.unit.size();
    Eigen::MatrixXd const information =
        weighted.transpose() * weighted + Eigen::MatrixXd::Identity(k, k) / prior_variance;
    VectorXd const reach = information.inverse().diagonal().cwiseSqrt();
    auto const clamped = [&](VectorXd const& unit) {
        return model.cube().to_values(unit.cwiseMax(0.0).cwiseMin(1.0));
    };
    return {model.values(minimum.unit, minimum.levels, first), clamped(minimum.unit - reach),
            clamped(minimum.unit + reach), minimum.misfit};
}

//! Largest form error at which something is still beyond chance; 0 where nothing is without one.
double form_error_that_hides(Evidence evidence, std::vector<CellGroup> const& groups)
{
    auto const is_beyond = [&](double form) {
        evidence.form_floor = form;
        Projection const projection(evidence, make_floor(evidence).total());
        return Locator(evidence, projection, groups).locate(evidence.residual()).beyond_floor();
    };
    double low = 0, high = 0.5;
    if (!is_beyond(low))
        return 0;
    if (is_beyond(high))
        return high;
    while (high - low > 1e-4)
        (is_beyond(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return high;
}

} // namespace

TableGap table_gap(MeasuredTable const& measured, tao_calib::LeastSquaresSolver const& solver)
{
    auto const& input = measured.fit.input();
    if (!measured.fit.space().free())
        throw InputError(fmt::format("{}: no factor that is a number is free", input.origin));
    Model const model(measured);
    TableGap gap;
    list_cells(gap, measured);
    if (gap.cells.empty())
        throw InputError(fmt::format("{}: no response was measured that can be fitted", input.origin));
    Evidence& evidence = gap.evidence;
    evidence.form_floor = input.form_floor;

    // The errors of predictions are those near the set that meets the measurements best without them.
    VectorXd deviations = evidence.experiment_variance.cwiseSqrt();
    Minimum best;
    for (int round = 0; round < 2; ++round) {
        best = best_of(model, measured, gap.cells, evidence.measured, deviations, solver);
        evidence.surrogate_variance = model.variances(gap.cells, best.unit, best.levels);
        evidence.predicted = model.predicted(gap.cells, best.unit, best.levels);
        evidence.nuisance = slopes(model, gap.cells, best);
        auto const factors = best.unit.size();
        evidence.nuisance_prior = prior_variance * Eigen::MatrixXd::Identity(factors, factors);
        deviations = make_floor(evidence).deviations();
    }
    best.misfit = evidence.residual().cwiseQuotient(deviations).squaredNorm();
    gap.best = optimum_of(model, measured.points.front(), best, evidence.nuisance, deviations);
    auto groups = groups_by_experiment(evidence.cells);
    for (auto& group : groups) {
        auto const& point = measured.points[static_cast<std::size_t>(
            gap.cells[static_cast<std::size_t>(group.cells.front())].point)];
        group.name = point.name;
        std::vector<TableCell> cells;
        for (int const c : group.cells)
            cells.push_back(gap.cells[static_cast<std::size_t>(c)]);
        VectorXd const own_deviations = deviations(group.cells);
        auto const minimum =
            best_of(model, measured, cells, evidence.measured(group.cells), own_deviations, solver);
        gap.own.push_back(optimum_of(model, point, minimum, slopes(model, cells, minimum), own_deviations));
    }
    Projection const projection(evidence, make_floor(evidence).total());
    gap.located = Locator(evidence, projection, groups).locate(evidence.residual());
    gap.form_error_that_hides_it = form_error_that_hides(evidence, groups);
    return gap;
}

} // namespace demens::gap
