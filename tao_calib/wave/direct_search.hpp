#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! POUNDERS on the simulation itself, from the best location of the design. The solver is run again from its
//! start each time, with simulated responses where there are any; at the first point that is not simulated
//! yet it goes on with the responses that the surrogates predict, and every new point that it asks for is
//! simulated in this wave. So its interpolation points are simulated at the same time, and the points that
//! follow are simulated ahead, on the prediction that the solver will ask for them. \return at most `count`
//! design points, own units; none when the solver has come to its end
std::vector<std::vector<double>> direct_points(ensemble::Campaign const& campaign,
                                               Assessment const& assessment, int count);

} // namespace demens::tao_calib
