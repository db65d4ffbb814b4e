#include "tao_calib/objective.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {

using ensemble::ObjectiveKind;
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-4; // of relative deviations about 0

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

Objective::Objective(ensemble::CampaignInput const& input) : Objective(targets_of(input), input.objective) {}

Objective::Objective(std::vector<CampaignTarget> targets, ensemble::ObjectiveOptions const& options)
    : targets_(std::move(targets)), kind_(options.kind),
      combinations_(static_cast<Index>(options.combinations.size()), size()), wanted_(residual_count()),
      units_(residual_count())
{
    VectorXd const sd = measurement_sd();
    auto set = [&](Index place, int t) {
        auto const& target = targets_[t].target;
        wanted_[place] = target.value;
        units_[place] = kind_ == ObjectiveKind::wmse                     ? target.scale
                        : kind_ == ObjectiveKind::weighted_least_squares ? sd[t]
                        : kind_ == ObjectiveKind::root_sum_of_squares    ? 1.0
                                                                         : std::abs(target.value);
    };
    for (int t = 0; t < size(); ++t) {
        set(t, t);
        weight_sum_ += 1 / (targets_[t].target.scale * targets_[t].target.scale);
    }
    for (Index c = 0; c < combinations_.rows(); ++c) {
        auto const& combination = options.combinations[static_cast<std::size_t>(c)];
        combinations_.row(c) = VectorXd::Map(combination.coefficients.data(), size()).transpose();
        set(size() + c, combination.target);
    }
}

VectorXd Objective::deviations(VectorXd const& responses) const
{
    VectorXd all(residual_count());
    all << responses, combinations_ * responses;
    return (all - wanted_).cwiseQuotient(units_);
}

double Objective::value(VectorXd const& responses) const
{
    VectorXd const all = deviations(responses);
    switch (kind_) {
    case ObjectiveKind::wmse:
        return all.squaredNorm() / (size() * weight_sum_);
    case ObjectiveKind::weighted_least_squares:
        return all.squaredNorm() / residual_count();
    case ObjectiveKind::root_sum_of_squares:
        return all.norm();
    case ObjectiveKind::relative_deviations:
        return all.cwiseAbs().sum();
    }
    return 0;
}

//! The size |d| of a relative deviation is the square of a residual that is rounded off near 0, r^2 =
//! sqrt(d^2 + e^2) - e, and has the sign of d.
VectorXd Objective::search_residuals(VectorXd const& responses) const
{
    VectorXd result = deviations(responses);
    if (kind_ == ObjectiveKind::relative_deviations)
        for (double& d : result)
            d = std::copysign(std::sqrt(std::hypot(d, rounding) - rounding), d);
    return result;
}

MatrixXd Objective::search_slopes(VectorXd const& responses) const
{
    MatrixXd slopes(residual_count(), size());
    slopes << MatrixXd::Identity(size(), size()), combinations_;
    VectorXd factors = units_.cwiseInverse();
    if (kind_ == ObjectiveKind::relative_deviations) {
        VectorXd const all = deviations(responses);
        for (Index i = 0; i < all.size(); ++i) {
            double const d = all[i], length = std::hypot(d, rounding);
            double const root = std::sqrt(length - rounding);
            factors[i] *= std::abs(d) > 1e-6 * rounding ? std::abs(d) / length / (2 * root)
                                                        : 1 / std::sqrt(2 * rounding);
        }
    }
    return factors.asDiagonal() * slopes;
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

double Objective::wmse(VectorXd const& responses) const
{
    return residuals(responses).squaredNorm() / (size() * weight_sum_);
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
