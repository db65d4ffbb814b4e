#pragma once

#include "ensemble/campaign.hpp"

namespace demens::report {

//! The run to show for an experiment: a finished one at the best location, else the last finished one; null:
//! none.
ensemble::RunRecord const* shown_run(ensemble::Campaign const& campaign, int experiment,
                                     ensemble::NamedArray const* best_point);

} // namespace demens::report
