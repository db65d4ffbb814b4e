#include "gap/campaign/base_surfaces.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/campaign_evidence.hpp"
#include "gap/campaign/simulated_points.hpp"
#include "tao_calib/wave/assessment.hpp"
#include "tao_calib/wave/target_surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace demens::gap {
namespace {

using Eigen::VectorXd;

constexpr int enough_repetitions = 10; //!< degrees of freedom from which on they alone tell how runs scatter
constexpr double most_of_floor = 0.25; //!< of a cell's variance that a surface may make out

//! Values of a response by location.
using Values = std::map<std::vector<double>, std::vector<double>>;

Values values_of(std::vector<SimulatedRun> const& runs, CampaignCell const& cell)
{
    Values values;
    for (auto const& run : runs)
        if (!run.effect && run.experiment == cell.cell.experiment)
            if (double const value = run.responses->at(static_cast<std::size_t>(cell.target->response_index));
                std::isfinite(value))
                values[run.factors].push_back(value);
    return values;
}

tao_calib::Samples samples_of(Values const& values, tao_calib::UnitCube const& cube)
{
    auto const n = static_cast<Eigen::Index>(values.size());
    tao_calib::Samples samples{Eigen::MatrixXd(n, cube.size()), VectorXd(n), VectorXd(n), VectorXd(n)};
    Eigen::Index row = 0;
    for (auto const& [factors, of_runs] : values) {
        Eigen::Map<VectorXd const> const all(of_runs.data(), static_cast<Eigen::Index>(of_runs.size()));
        samples.points.row(row) = cube.to_unit(Eigen::Map<VectorXd const>(
                                                   factors.data(), static_cast<Eigen::Index>(factors.size())))
                                      .transpose();
        samples.values[row] = all.mean();
        samples.weights[row] = static_cast<double>(all.size());
        samples.squared_deviations[row] = (all.array() - all.mean()).square().sum();
        ++row;
    }
    return samples;
}

//! By repetitions, or from what the surface predicts of runs that it does not know.
double variance_of_run(tao_calib::Samples const& samples, tao_calib::Surrogate const& surface)
{
    double const repeated = samples.weights.sum() - static_cast<double>(samples.weights.size());
    if (repeated >= enough_repetitions)
        return samples.squared_deviations.sum() / repeated;
    auto const& errors = surface.leave_one_out_errors();
    return samples.weights.dot(VectorXd(errors.array().square())) / static_cast<double>(errors.size());
}

} // namespace

BaseSurfaces::BaseSurfaces(ensemble::Campaign const& campaign, tao_calib::UnitCube const& cube,
                           std::vector<CampaignCell> const& cells)
    : free_(cube.free_factors()), run_variances_(static_cast<Eigen::Index>(cells.size()))
{
    auto const runs = simulated_runs(campaign);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        auto const values = values_of(runs, cells[i]);
        int const needed = tao_calib::Assessment::locations_needed(cube.size());
        if (static_cast<int>(values.size()) < needed)
            throw InputError(fmt::format("{}: {} design points have a value, {} are needed to know how it "
                                         "changes with the factors",
                                         cells[i].cell.name, values.size(), needed));
        auto const samples = samples_of(values, cube);
        surfaces_.push_back(tao_calib::fit_target(campaign.input.surrogate.kind, *cells[i].target, samples));
        run_variances_[static_cast<Eigen::Index>(i)] = variance_of_run(samples, *surfaces_.back());
    }
}

double BaseSurfaces::value(int cell, VectorXd const& unit) const
{
    return surfaces_[static_cast<std::size_t>(cell)]->value(unit);
}

double BaseSurfaces::deviation(int cell, VectorXd const& unit) const
{
    return surfaces_[static_cast<std::size_t>(cell)]->supported_deviation(unit);
}

VectorXd BaseSurfaces::values(VectorXd const& unit) const
{
    VectorXd values(run_variances_.size());
    for (int i = 0; i < values.size(); ++i)
        values[i] = value(i, unit);
    return values;
}

VectorXd BaseSurfaces::deviations(VectorXd const& unit) const
{
    VectorXd deviations(run_variances_.size());
    for (int i = 0; i < deviations.size(); ++i)
        deviations[i] = deviation(i, unit);
    return deviations;
}

Eigen::MatrixXd BaseSurfaces::slopes(VectorXd const& unit) const
{
    Eigen::MatrixXd slopes(run_variances_.size(), static_cast<Eigen::Index>(free_.size()));
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
        VectorXd const gradient = surfaces_[static_cast<std::size_t>(i)]->gradient(unit);
        for (Eigen::Index j = 0; j < slopes.cols(); ++j)
            slopes(i, j) = gradient[free_[static_cast<std::size_t>(j)]];
    }
    return slopes;
}

bool has_surfaces(ensemble::Campaign const& campaign, std::vector<CampaignCell> const& cells)
{
    if (!has_bank(campaign) || cells.empty())
        return false;
    auto const runs = simulated_runs(campaign);
    int const needed =
        tao_calib::Assessment::locations_needed(static_cast<int>(campaign.input.factors.size()));
    return std::all_of(cells.begin(), cells.end(), [&](auto const& cell) {
        return static_cast<int>(values_of(runs, cell).size()) >= needed;
    });
}

bool has_surfaces(ensemble::Campaign const& campaign, ensemble::ExperimentRole role)
{
    return has_surfaces(campaign, cells_of(campaign.input, role));
}

bool is_sure_at_estimate(ensemble::Campaign const& campaign, CalibratedModel const& model)
{
    auto const cells = cells_of(campaign.input, ensemble::ExperimentRole::calibrate);
    VectorXd const deviations = BaseSurfaces(campaign, model.cube, cells).deviations(model.unit);
    double const form_floor = campaign.input.gap.value_or(ensemble::GapOptions{}).form_floor;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        double const surface = std::pow(deviations[static_cast<Eigen::Index>(i)], 2);
        double const others = std::pow(cells[i].sd, 2) + std::pow(form_floor * cells[i].cell.scale, 2);
        if (surface > most_of_floor * (surface + others))
            return false;
    }
    return true;
}

} // namespace demens::gap
