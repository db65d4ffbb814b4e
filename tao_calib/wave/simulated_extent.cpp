#include "tao_calib/wave/simulated_extent.hpp"

#include <algorithm>
#include <limits>

namespace demens::tao_calib {

using Eigen::VectorXd;

namespace {

std::vector<VectorXd> complete_locations(Assessment const& assessment)
{
    std::vector<VectorXd> places;
    for (auto const& location : assessment.locations().all())
        if (location.complete())
            places.push_back(location.unit);
    return places;
}

} // namespace

SimulatedExtent::SimulatedExtent(Assessment const& assessment)
    : SimulatedExtent(assessment.cube(), complete_locations(assessment))
{
}

SimulatedExtent::SimulatedExtent(UnitCube const& cube, std::vector<VectorXd> const& reached)
    : free_factors_(cube.free_factors()),
      lower_(VectorXd::Constant(cube.size(), std::numeric_limits<double>::infinity())), upper_(-lower_)
{
    for (auto const& place : reached) {
        lower_ = lower_.cwiseMin(place);
        upper_ = upper_.cwiseMax(place);
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
