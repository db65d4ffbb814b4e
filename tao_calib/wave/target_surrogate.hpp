#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

#include <memory>

namespace demens::tao_calib {

//! Fits the response that a target is compared with, in the transform that the target asks for.
std::unique_ptr<Surrogate> fit_target(SurrogateChoice choice, ensemble::Target const& target,
                                      Samples const& samples);

} // namespace demens::tao_calib
