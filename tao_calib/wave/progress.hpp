#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! Search waves since the fit last became better by more than noise: since the least sum of squared
//! deviations, each over its standard deviation (the scatter between runs counted in, where repetitions tell
//! it), fell by more than a tenth per target and a fiftieth of itself. A luckier run or a smaller rounding is
//! no gain.
int waves_in_vain(ensemble::Campaign const& campaign, Assessment const& assessment);

//! Whether the best location meets every target within a tenth of its standard deviation.
bool met_within_noise(Assessment const& assessment);

//! Whether no further run can bring the fit closer to the targets than the measurement tells, or tell more:
//! the sum of squared deviations of the best location, each over the standard deviation of the measurement,
//! is within a hundredth per target of the least that the surrogates predict (or of the responses at the
//! optimum that `[objective]` asks for), and predictions there are sure within a tenth of that standard
//! deviation. \param latest arrays of the last wave, where they are not stored with it yet
bool best_is_as_good_as_can_be(ensemble::Campaign const& campaign, Assessment const& assessment,
                               std::vector<ensemble::NamedArray> const& latest);

//! Whether the intervals of all factors have moved by less than a tenth of their widths with the last wave.
//! \param latest arrays of the last wave, where they are not stored with it yet
bool intervals_settled(ensemble::Campaign const& campaign, std::vector<ensemble::NamedArray> const& latest);

} // namespace demens::tao_calib
