#pragma once

#include "gap/campaign/diagnosis.hpp"

#include <optional>
#include <string>

namespace demens::gap {

//! What the diagnosis will cost.
struct Price
{
    int screening;  //!< runs of the base model and the first look at every effect
    int full;       //!< runs of the most probable effects
    int held_out;   //!< runs on what is held out
    int considered; //!< runs on experiments that might be made
    int total() const { return screening + full + held_out + considered; }
};

//! At most, before anything is known.
Price price_of(ensemble::CampaignInput const& input);

//! The same in words.
std::string price_text(ensemble::CampaignInput const& input);

//! What a user should know of a campaign with `[gap]` before it runs: its price, what is missing. \throws
//! InputError for effects that cannot be looked at
std::vector<std::string> announcement(ensemble::CampaignInput const& input);

//! The next wave of a campaign that is calibrated; none when the diagnosis is complete. A function of the
//! campaign's content alone. \throws InputError where nothing can be diagnosed
std::optional<ensemble::WavePlan> next_wave(ensemble::Campaign const& campaign);

//! Base model and the most probable effects on the experiments that might be made.
ensemble::WavePlan candidate_wave(ensemble::Campaign const& campaign, Diagnosis const& diagnosis);
//! The wave of first looks, about the middle of the factors: for a plan before anything is measured.
ensemble::WavePlan screening_wave(ensemble::Campaign const& campaign, Centre centre);

} // namespace demens::gap
