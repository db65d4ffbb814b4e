#pragma once

#include "gap/campaign/calibrated_model.hpp"
#include "gap/campaign/campaign_cells.hpp"
#include "gap/campaign/simulated_points.hpp"
#include "gap/catalogue/catalogue.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! What a campaign says about its gap, as arrays.
struct CampaignEvidence
{
    CalibratedModel model;
    std::vector<CampaignCell> cells; //!< fitted ones, as in `evidence`
    Evidence evidence;
    std::vector<CandidateEffect> candidates; //!< effects whose signatures are known
    std::vector<Signature> signatures;       //!< theirs
    std::vector<std::string> notes;          //!< what was assumed or is missing, one line each
};

//! From the calibration's waves and those of signatures. The prior of the factors is as wide as their ranges.
//! \throws InputError where nothing is calibrated, where the base model's runs failed, or there is no fitted
//! target
CampaignEvidence evidence_of(ensemble::Campaign const& campaign, Centre centre);

//! What was measured in these cells, and how runs of the points scatter there; neither predictions nor slopes
//! yet. \param base whose runs a prediction is the mean of; null: it is not made of runs at one point
Evidence measured_evidence(std::vector<CampaignCell> const& cells, std::vector<SimulatedPoint> const& points,
                           SimulatedPoint const* base, double form_floor);

} // namespace demens::gap
