#include "gap/campaign/calibrated_model.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/wave/assessment.hpp"
#include "tao_calib/wave/target_surrogate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

VectorXd estimate_of(ensemble::Campaign const& campaign)
{
    auto const analysed = std::find_if(campaign.waves.rbegin(), campaign.waves.rend(), [](auto const& wave) {
        return wave.find(ensemble::stored::optimum::estimate) != nullptr;
    });
    if (analysed == campaign.waves.rend())
        throw InputError("the campaign has no estimate of its factors, so that there is no calibrated model "
                         "whose gap could be diagnosed; `demens status` says how far its calibration came");
    auto const& data = analysed->find(ensemble::stored::optimum::estimate)->data;
    VectorXd const estimate = Eigen::Map<VectorXd const>(data.data(), static_cast<Eigen::Index>(data.size()));
    if (!estimate.allFinite())
        throw InputError(
            "the campaign's estimate lies where no run supports it, so that there is no calibrated "
            "model whose gap could be diagnosed; give the factors wider bounds, or more runs");
    return estimate;
}

} // namespace

VectorXd CalibratedModel::place(std::vector<double> const& values) const
{
    return cube.to_unit(Eigen::Map<VectorXd const>(values.data(), static_cast<Eigen::Index>(values.size())));
}

std::vector<double> CalibratedModel::moved(VectorXd const& change) const
{
    VectorXd place = unit;
    for (Eigen::Index j = 0; j < change.size(); ++j)
        place[cube.free_factors()[static_cast<std::size_t>(j)]] += change[j];
    return cube.to_design_point(cube.project(place.cwiseMax(0).cwiseMin(1)));
}

CalibratedModel calibrated_model(ensemble::Campaign const& campaign, Centre centre)
{
    auto const& input = campaign.input;
    tao_calib::Objective objective(input);
    auto const screening = tao_calib::screen(campaign, objective);
    tao_calib::UnitCube const cube(input.factors, input.constraints, screening.fixed());
    tao_calib::Locations const locations(objective, cube, campaign);
    int const needed = tao_calib::Assessment::locations_needed(cube.size());
    if (locations.complete() < needed)
        throw InputError(fmt::format("{} design points have a value for every target, {} are needed to know "
                                     "how responses change with the factors",
                                     locations.complete(), needed));
    VectorXd const wanted = centre == Centre::estimate
                                ? cube.to_unit(estimate_of(campaign))
                                : cube.project(cube.pinned(VectorXd::Constant(cube.size(), 0.5)));
    auto const point = cube.to_design_point(cube.project(wanted));
    VectorXd const unit =
        cube.to_unit(Eigen::Map<VectorXd const>(point.data(), static_cast<Eigen::Index>(point.size())));
    auto const& free = cube.free_factors();
    MatrixXd slopes(objective.size(), static_cast<Eigen::Index>(free.size()));
    for (int t = 0; t < objective.size(); ++t) {
        auto const& target = objective.targets()[static_cast<std::size_t>(t)].target;
        auto const gradient =
            tao_calib::fit_target(input.surrogate.kind, target, locations.samples(t))->gradient(unit);
        for (std::size_t j = 0; j < free.size(); ++j)
            slopes(t, static_cast<Eigen::Index>(j)) = gradient[free[j]];
    }
    return {std::move(objective), cube, point, unit, std::move(slopes)};
}

} // namespace demens::gap
