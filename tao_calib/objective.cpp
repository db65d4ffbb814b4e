#include "tao_calib/objective.hpp"

#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

std::vector<CampaignTarget> targets_of(ensemble::CampaignInput const& input)
{
    std::vector<CampaignTarget> targets;
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto const& experiment = input.experiments[e];
        for (auto const& target : experiment.targets)
            targets.push_back({static_cast<int>(e), target, experiment.name + "." + target.response,
                               experiment.responses.at(target.response_index).units});
    }
    return targets;
}

} // namespace

Objective::Objective(ensemble::CampaignInput const& input) : Objective(targets_of(input)) {}

Objective::Objective(std::vector<CampaignTarget> targets) : targets_(std::move(targets))
{
    for (auto const& t : targets_)
        weight_sum_ += 1 / (t.target.scale * t.target.scale);
}

VectorXd Objective::residuals(VectorXd const& responses) const
{
    VectorXd result(size());
    for (int t = 0; t < size(); ++t)
        result[t] = (responses[t] - targets_[t].target.value) / targets_[t].target.scale;
    return result;
}

double Objective::mean_square_residual(VectorXd const& responses) const
{
    return residuals(responses).squaredNorm() / size();
}

double Objective::wmse_from(double sum_of_squares) const
{
    return sum_of_squares / (size() * weight_sum_);
}

double Objective::wmse(VectorXd const& responses) const
{
    return wmse_from(residuals(responses).squaredNorm());
}

bool Objective::within_tolerance(VectorXd const& responses) const
{
    bool any = false;
    for (int t = 0; t < size(); ++t) {
        auto const& target = targets_[t].target;
        if (std::isnan(target.tolerance))
            continue;
        any = true;
        if (!(std::abs(responses[t] - target.value) <= target.tolerance))
            return false;
    }
    return any;
}

VectorXd Objective::measurement_sd() const
{
    VectorXd result(size());
    for (int t = 0; t < size(); ++t)
        result[t] = std::isnan(targets_[t].target.sd) ? targets_[t].target.scale : targets_[t].target.sd;
    return result;
}

} // namespace demens::tao_calib
