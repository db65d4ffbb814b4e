#pragma once

#include "gap/campaign/base_surfaces.hpp"
#include "gap/campaign/campaign_signature.hpp"

#include <vector>

namespace demens::gap {

//! Whether an effect was run often enough, at places all over the factors, on all fitted experiments that it
//! changes. Runs of the same settings count, whatever the effect is called there.
bool is_spread(ensemble::Effect const& effect, ensemble::CampaignInput const& input,
               std::vector<SimulatedRun> const& runs);

//! Signature at theta0 from runs of the effect at places all over the factors: what they say beyond the base
//! model's surface is a (s + T d) + a^2 q, by least squares in which T and q are held to sizes like that of
//! s. 0 on experiments that the effect does not change.
MadeSignature spread_signature(CandidateEffect const& candidate, CampaignEvidence const& of,
                               BaseSurfaces const& surfaces, std::vector<SimulatedRun> const& runs,
                               ensemble::CampaignInput const& input);

} // namespace demens::gap
