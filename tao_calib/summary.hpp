#pragma once

#include "ensemble/campaign.hpp"

#include <string>

namespace demens::tao_calib {

//! Plain text for the end of a run: best point with intervals and verdicts, targets against simulated values,
//! run counts, why it ended. Reads what was stored with the last analysed wave; calculates nothing.
std::string summary(ensemble::Campaign const& campaign);

} // namespace demens::tao_calib
