#include "tao_calib/wave/feasibility.hpp"

#include <cmath>

namespace demens::tao_calib {
namespace {

constexpr double reach = 0.1; // in shares of the ranges, for one factor
constexpr double doubt = 0.1; // weight of the overall share

} // namespace

Feasibility::Feasibility(Locations const& locations)
{
    double sum = 0;
    for (auto const& location : locations.all()) {
        double const runs = location.finished_runs + location.failed_runs;
        if (runs == 0)
            continue;
        points_.push_back(location.unit);
        shares_.push_back(location.complete() ? location.finished_runs / runs : 0);
        sum += shares_.back();
    }
    if (!shares_.empty())
        overall_ = sum / static_cast<double>(shares_.size());
}

double Feasibility::chance(Eigen::VectorXd const& unit) const
{
    if (overall_ == 1)
        return 1;
    double const scale = reach * std::sqrt(static_cast<double>(unit.size()));
    double good = doubt * overall_, all = doubt;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        double const weight = std::exp(-0.5 * (points_[i] - unit).squaredNorm() / (scale * scale));
        good += weight * shares_[i];
        all += weight;
    }
    return good / all;
}

} // namespace demens::tao_calib
