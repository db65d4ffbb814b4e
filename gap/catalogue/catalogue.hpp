#pragma once

#include "gap/catalogue/entry.hpp"

#include <vector>

namespace demens::gap {

//! All effects that a model may be asked about, what users meet most first within each group.
std::vector<CatalogueEntry> const& catalogue();

//! An effect of this campaign that is looked at.
struct CandidateEffect
{
    ensemble::Effect effect; //!< without settings where `measured` is there
    std::string group;       //!< of the catalogue, or `own`
    std::string amplitude;   //!< what its amplitude is
    MeasuredChange measured = nullptr;
};

//! The effects that `[gap]` names, or else all that the rigs and laws of the campaign allow, and its own.
//! \throws InputError for a name that is unknown, an effect that this campaign does not allow, two that
//! change the same, an amplitude that a rig refuses
std::vector<CandidateEffect> candidates_of(ensemble::CampaignInput const& input);

} // namespace demens::gap
