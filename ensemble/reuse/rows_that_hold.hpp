#pragma once

#include "ensemble/campaign.hpp"

#include <functional>
#include <string>
#include <vector>

//! Runs of one campaign file that another campaign may take over, so that nothing is simulated twice.
namespace demens::ensemble {

//! Runs of another campaign that would be runs of this one.
struct RowsThatHold
{
    //! Factors, experiments and responses as this campaign has them; all else, numbers too, as there.
    std::vector<RunRecord> runs;
    //! Why others do not hold, one line each: path, what it is here and there.
    std::vector<std::string> differences;

    //! How many are of an experiment of this campaign.
    int of(int experiment) const;
};

//! Gives the curves of a run of the other campaign.
using DetailsThere = std::function<RunDetails(RunRecord const&)>;

//! A run holds if everything that it was made from, beside its seed, is what this campaign has at some values
//! of its factors, within their bounds and constraints: the experiment of that name, its rig, materials,
//! contacts and sizes. What is measured, replicates, searches and engines do not matter; factors may differ.
//! Responses that come of measured curves and pictures hold where these are the same; else they are made anew
//! of the curves that the run has kept. Runs that have not ended are left out, failed ones hold.
//! \param details_of none: nothing can be made anew
RowsThatHold rows_that_hold(CampaignInput const& here, Campaign const& there,
                            DetailsThere const& details_of = {});

} // namespace demens::ensemble
