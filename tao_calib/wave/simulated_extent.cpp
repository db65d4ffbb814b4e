#include "tao_calib/wave/simulated_extent.hpp"

#include <algorithm>
#include <limits>

namespace demens::tao_calib {

using Eigen::VectorXd;

SimulatedExtent::SimulatedExtent(Assessment const& assessment)
    : free_factors_(assessment.cube().free_factors()),
      lower_(VectorXd::Constant(assessment.cube().size(), std::numeric_limits<double>::infinity())),
      upper_(-lower_)
{
    for (auto const& location : assessment.locations().all())
        if (location.complete()) {
            lower_ = lower_.cwiseMin(location.unit);
            upper_ = upper_.cwiseMax(location.unit);
        }
}

bool SimulatedExtent::holds(int factor, double place) const
{
    constexpr double rounding = 1e-9;
    double const beyond = 0.25 * (upper_[factor] - lower_[factor]) + rounding;
    return place >= lower_[factor] - beyond && place <= upper_[factor] + beyond;
}

bool SimulatedExtent::holds(VectorXd const& unit) const
{
    return std::all_of(free_factors_.begin(), free_factors_.end(), [&](int j) { return holds(j, unit[j]); });
}

} // namespace demens::tao_calib
