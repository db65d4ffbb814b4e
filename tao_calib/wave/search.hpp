#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! Design points of a search wave, own units, in the way that `[solver] kind` asks for; by default the best
//! predicted point, further distinct minima that promise more than the best simulated location, and points
//! that improve the surrogates. None is close to a location that exists; none at all: the search has come to
//! its end.
std::vector<std::vector<double>> search_points(ensemble::Campaign const& campaign,
                                               Assessment const& assessment, int count, std::uint64_t seed);

//! Design points spread over the feasible region, far from all locations; own units.
std::vector<std::vector<double>> filling_points(Assessment const& assessment, int count, std::uint64_t seed);

} // namespace demens::tao_calib
