#pragma once

#include "gap/campaign/campaign_evidence.hpp"
#include "gap/statistics/attribute.hpp"
#include "gap/statistics/floor.hpp"
#include "gap/statistics/refit.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! What a campaign's runs say about its gap, as far as they go. Not to be copied: its parts refer to each
//! other.
class Diagnosis
{
  public:
    //! \throws InputError where nothing can be diagnosed
    Diagnosis(ensemble::Campaign const& campaign, Centre centre = Centre::estimate);
    Diagnosis(Diagnosis const&) = delete;
    Diagnosis& operator=(Diagnosis const&) = delete;

    CampaignEvidence const& campaign() const { return campaign_; }
    Evidence const& evidence() const { return campaign_.evidence; }
    std::vector<Signature> const& effects() const { return campaign_.signatures; }
    Floor const& floor() const { return floor_; }
    Projection const& projection() const { return projection_; }
    Hypotheses const& hypotheses() const { return hypotheses_; }
    Attributor const& attributor() const { return attributor_; }
    Locator const& locator() const { return locator_; }
    Located const& located() const { return located_; }
    std::vector<CellGroup> const& groups() const { return groups_; }
    Attribution const& attribution() const { return attribution_; }
    Distances distances(double strength = 1) const;

    //! The same with p of each effect's closure among decoys.
    Attribution attribution_with(std::vector<double> const& decoy_p) const;
    //! Places of the simulated effects, most probable first.
    std::vector<int> ranked_effects() const;
    //! The calibration done again: with no effect, or with one.
    Refit refitted() const;
    Refit refitted_with(int effect) const;

  private:
    CampaignEvidence campaign_;
    Floor floor_;
    Projection projection_;
    std::vector<CellGroup> groups_;
    Locator locator_;
    Hypotheses hypotheses_;
    Attributor attributor_;
    Located located_;
    Attribution attribution_;
};

} // namespace demens::gap
