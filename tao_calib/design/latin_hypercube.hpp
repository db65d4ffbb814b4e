#pragma once

#include "tao_calib/design/factor_space.hpp"

namespace demens::tao_calib {

//! Latin hypercube whose points keep as far apart as can be found: places 0 ... points-1, each once in every
//! column [points x factors]. Of more than 2,800 points a random one, since their distances are too many to
//! look at.
Eigen::MatrixXi maximin_latin_hypercube(int points, int factors, std::uint64_t seed);

//! Smallest squared distance between two rows.
int smallest_squared_distance(Eigen::MatrixXi const& places);

//! Points of the unit cube [points x factors] in a region cut by constraints.
struct ConstrainedLatinHypercube
{
    Eigen::MatrixXd unit;
    int empty_strata; //!< of points x factors equally likely strata, how many hold no point
};
ConstrainedLatinHypercube constrained_latin_hypercube(FactorSpace const& space, int points,
                                                      std::uint64_t seed);

} // namespace demens::tao_calib
