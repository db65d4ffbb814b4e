#include "tao_calib/wave/choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {

using Eigen::VectorXd;

Choice::Choice(Assessment const& assessment, double shrinking)
    : cube_(assessment.cube()), feasibility_(assessment.locations()), shrinking_(shrinking)
{
    for (auto const& location : assessment.locations().all())
        taken_.push_back(location.unit);
}

VectorXd Choice::simulated(VectorXd const& unit) const
{
    auto const values = cube_.to_design_point(unit);
    return cube_.to_unit(Eigen::Map<VectorXd const>(values.data(), cube_.size()));
}

double Choice::distance(VectorXd const& unit) const
{
    double least = std::numeric_limits<double>::infinity();
    for (auto const& other : taken_)
        least = std::min(least, (other - unit).norm());
    return least;
}

bool Choice::is_new(VectorXd const& unit) const
{
    return distance(unit) > spacing() && runs_well(unit);
}

double Choice::spacing() const
{
    return 0.02 * shrinking_ * std::sqrt(cube_.size());
}

bool Choice::is_other(VectorXd const& unit) const
{
    return distance(unit) > 2e-4 * std::sqrt(unit.size()) && runs_well(unit);
}

void Choice::take(VectorXd const& unit)
{
    points_.push_back(cube_.to_design_point(unit));
    taken_.push_back(unit);
}

} // namespace demens::tao_calib
