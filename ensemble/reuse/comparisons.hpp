#pragma once

#include "ensemble/input/campaign_input.hpp"

namespace demens::ensemble {

//! Whether measured curves and pictures make the same responses of a run, whatever their `sd` and weights.
//! \param here, there files that the campaigns of the experiments name
bool are_same_comparisons(Experiment const& one, Experiment const& other, rig::Files const& here,
                          rig::Files const& there);

//! How many responses the rig itself gives, before those that curves and a picture add.
std::size_t responses_of_rig(Experiment const& experiment);

} // namespace demens::ensemble
