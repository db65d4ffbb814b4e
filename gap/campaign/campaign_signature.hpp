#pragma once

#include "gap/campaign/campaign_evidence.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! How all cells change with an effect, or why that is not known.
struct MadeSignature
{
    Signature signature;
    std::string reason; //!< empty: the signature is there
};

//! First and second order by least squares over its amplitudes at theta0, interaction with each factor by the
//! difference of its change on either side of theta0, where these were simulated.
//! \param of the cells, the base model's means and slopes \param points of the waves of signatures
MadeSignature signature_of(CandidateEffect const& candidate, CampaignEvidence const& of,
                           std::vector<SimulatedPoint> const& points);

//! A signature of as many cells that changes nothing yet.
Signature empty_signature(CandidateEffect const& candidate, Eigen::Index cells);

//! Amplitudes at which an effect is simulated: the first look, and all of them in full.
std::vector<double> screening_amplitudes(ensemble::Effect const& effect);
//! \param fitted amplitude that the first look gives it
std::vector<double> full_amplitudes(ensemble::Effect const& effect, double fitted);
//! Changes of the free factors (unit cube) about theta0 at which an effect in full is simulated, two a
//! factor.
std::vector<Eigen::VectorXd> interaction_changes(CalibratedModel const& model);

} // namespace demens::gap
