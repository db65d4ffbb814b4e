#pragma once

#include "tao_calib/wave/choice.hpp"

namespace demens::tao_calib {

//! Adaptive response surface method (after HyperStudy's ARSM in the wood powder paper): quadratics fitted
//! anew to all runs, each counting by its closeness to the best location; their minimum within move limits
//! about it; and points spread within these limits. The limits halve after every search wave that found
//! nothing better.
void take_response_surface_points(ensemble::Campaign const& campaign, Assessment const& assessment, int count,
                                  std::uint64_t seed, Choice& choice);

} // namespace demens::tao_calib
