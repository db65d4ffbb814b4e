#pragma once

#include "gap/campaign/diagnosis.hpp"
#include "gap/statistics/quantify.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demens::gap {

//! How far an effect closes the gap where nothing was fitted.
struct EffectClosure
{
    int effect;       //!< place among the effects of the diagnosis
    double amplitude; //!< as fitted
    Closure closure;
    double decoy_p;         //!< of its closure among decoys; NaN at the floor
    int decoys;             //!< how many there are
    double best_decoy;      //!< the closure of the best; NaN without any
    std::string decoy_name; //!< what that is
};

//! What the runs on held-out experiments say.
struct CampaignClosure
{
    std::vector<CampaignCell> cells;    //!< held out
    std::vector<EffectClosure> effects; //!< those that were simulated there, most probable first
    std::string failure;                //!< why nothing can be said; empty: all is there

    //! p of the closure among decoys for each effect of the diagnosis; NaN where it was not tried.
    std::vector<double> decoy_p(std::size_t effects) const;
};

//! None where nothing was run on held-out experiments.
std::optional<CampaignClosure> closure_of(ensemble::Campaign const& campaign, Diagnosis const& diagnosis);

} // namespace demens::gap
