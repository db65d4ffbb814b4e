#pragma once

#include "ensemble/campaign.hpp"

#include <vector>

namespace demens::tao_calib {

//! What a campaign that has kept runs of an earlier input needs before it can search: fitted experiments that
//! nobody ran, at the locations of the others, as many as its design has; and the points of its design that
//! lie beyond all that was simulated, along a factor that is new or has wider bounds. Where nothing was kept,
//! its design and the points to start from. None where nothing is missing.
//! \param starts points worth a run, own units
std::vector<ensemble::WavePlan> completing_waves(ensemble::Campaign const& kept,
                                                 std::vector<std::vector<double>> const& starts = {});

} // namespace demens::tao_calib
