#pragma once

#include "tao_calib/wave/assessment.hpp"

#include <vector>

namespace demens::tao_calib {

//! The arrays that ANALYSIS.md lists, to be stored with the campaign's last wave. `assessment` is the
//! campaign's.
std::vector<ensemble::NamedArray> analysis_arrays(ensemble::Campaign const& campaign,
                                                  Assessment const& assessment);

} // namespace demens::tao_calib
