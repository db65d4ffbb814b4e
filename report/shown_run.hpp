#pragma once

#include "ensemble/campaign.hpp"

#include <vector>

namespace demens::report {

//! The run to show for an experiment: a finished one at the best location, else the last finished one; null:
//! none.
ensemble::RunRecord const* shown_run(ensemble::Campaign const& campaign, int experiment,
                                     ensemble::NamedArray const* best_point);

//! The numbers of these runs at the best point so far, of all experiments that have one.
std::vector<int> shown_runs(ensemble::Campaign const& campaign);

} // namespace demens::report
