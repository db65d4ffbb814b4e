#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace demens::tao_calib {

//! Points of the first wave, and what its author should know of how they came to be.
struct Design
{
    Eigen::MatrixXd points;         //!< one design point a row, factors' own units
    std::vector<std::string> notes; //!< points moved or dropped for a constraint, aliases, ...
};

//! The design that the options name; every point is within bounds and constraints. The same seed gives the
//! same design. \throws InputError when the options do not fit the factors.
Design plan_design(ensemble::DesignOptions const& options, std::vector<ensemble::Factor> const& factors,
                   std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed);

//! The points of plan_design().
Eigen::MatrixXd make_design(ensemble::DesignOptions const& options,
                            std::vector<ensemble::Factor> const& factors,
                            std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed);

} // namespace demens::tao_calib
