#include "gap/campaign/unfitted_runs.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/base_surfaces.hpp"
#include "gap/campaign/campaign_signature.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {

using Eigen::MatrixXd, Eigen::VectorXd;

UnfittedRuns::UnfittedRuns(ensemble::Campaign const& campaign, Diagnosis const& diagnosis,
                           std::vector<CampaignCell> const& cells, ensemble::WavePurpose purpose)
    : found_(diagnosis), cells_(cells), points_(simulated_points(campaign, purpose))
{
    auto const* at_theta0 = base(VectorXd::Zero(diagnosis.evidence().factors()));
    double const form_floor = campaign.input.gap.value_or(ensemble::GapOptions{}).form_floor;
    if (!at_theta0 && has_surfaces(campaign, cells)) {
        auto const& model = diagnosis.campaign().model;
        BaseSurfaces const surfaces(campaign, model.cube, cells);
        auto const* refitted = base(diagnosis.refitted().factors);
        means(refitted, "the base model, calibrated again"); // that it has some
        evidence_ = measured_evidence(cells, points_, refitted, form_floor);
        evidence_.predicted = surfaces.values(model.unit);
        evidence_.nuisance = surfaces.slopes(model.unit);
    } else {
        auto const predicted = means(at_theta0, "the calibrated model");
        evidence_ = measured_evidence(cells, points_, at_theta0, form_floor);
        evidence_.predicted = predicted;
        evidence_.nuisance = slopes();
    }
    evidence_.nuisance_prior = diagnosis.evidence().nuisance_prior;
}

SimulatedPoint const* UnfittedRuns::base(VectorXd const& change) const
{
    return find_point(points_, found_.campaign().model.moved(change), "", 0);
}

SimulatedPoint const* UnfittedRuns::with(std::string const& effect) const
{
    auto const found = std::find_if(points_.begin(), points_.end(), [&](auto const& point) {
        return point.effect == effect && std::all_of(cells_.begin(), cells_.end(), [&](auto const& cell) {
                   return point.has(cell.cell.experiment);
               });
    });
    return found == points_.end() ? nullptr : &*found;
}

VectorXd UnfittedRuns::signature(SimulatedPoint const& point, VectorXd const& change) const
{
    return (means(&point, point.effect) - evidence_.predicted - evidence_.nuisance * change) /
           point.amplitude;
}

VectorXd UnfittedRuns::means(SimulatedPoint const* point, std::string const& what) const
{
    VectorXd means(static_cast<Eigen::Index>(cells_.size()));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        int const e = cells_[i].cell.experiment;
        if (!point || !point->has(e))
            throw InputError(
                fmt::format("{} has no finished run of an experiment that nothing is fitted to ({}){}{}",
                            what, cells_[i].cell.name, point && !point->failure.empty() ? "; " : "",
                            point ? point->failure : ""));
        means[static_cast<Eigen::Index>(i)] = point->mean(e, cells_[i].target->response_index);
    }
    return means;
}

MatrixXd UnfittedRuns::packings(SimulatedPoint const& point) const
{
    int rows = std::numeric_limits<int>::max();
    for (auto const& cell : cells_)
        rows = std::min(rows, point.count(cell.cell.experiment));
    MatrixXd packings(rows, static_cast<Eigen::Index>(cells_.size()));
    for (std::size_t i = 0; i < cells_.size(); ++i)
        for (int r = 0; r < rows; ++r)
            packings(r, static_cast<Eigen::Index>(i)) =
                point.runs[static_cast<std::size_t>(cells_[i].cell.experiment)][static_cast<std::size_t>(r)]
                          [cells_[i].target->response_index];
    return packings;
}

//! By differences across theta0.
MatrixXd UnfittedRuns::slopes() const
{
    auto const& model = found_.campaign().model;
    auto const changes = interaction_changes(model);
    auto const p = model.slopes.cols();
    MatrixXd slopes(static_cast<Eigen::Index>(cells_.size()), p);
    for (Eigen::Index j = 0; j < p; ++j) {
        int const factor = model.cube.free_factors()[static_cast<std::size_t>(j)];
        auto const& lower = changes[static_cast<std::size_t>(2 * j)];
        auto const& upper = changes[static_cast<std::size_t>(2 * j + 1)];
        double const step = model.place(model.moved(upper))[factor] - model.place(model.moved(lower))[factor];
        auto const what = "the model with " + model.cube.factor(factor).name + " changed";
        slopes.col(j) = (means(base(upper), what) - means(base(lower), what)) / step;
    }
    return slopes;
}

Signature with_first_order(Signature effect, VectorXd const& first)
{
    effect.first = first;
    effect.interaction.resize(0, 0);
    effect.second.resize(0);
    effect.first_variance.resize(0);
    return effect;
}

} // namespace demens::gap
