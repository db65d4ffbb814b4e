#pragma once

#include "ensemble/campaign.hpp"

#include <optional>
#include <vector>

//! A bank: runs all over the range of the factors, of the base model and of every effect, that campaigns with
//! the same rigs take over. Nothing needs to be measured for it.
namespace demens::gap {

//! Experiments of these roles that an effect changes, at its typical amplitude.
std::vector<int> experiments_changed(ensemble::CampaignInput const& input, ensemble::Effect const& effect,
                                     ensemble::ExperimentRole role);

//! All waves of a bank after its design, in their order: each effect at so many points on what is fitted,
//! then the base model at the points of the design and each effect on what is held out. \throws InputError
std::vector<ensemble::WavePlan> bank_waves(ensemble::Campaign const& campaign, int points_per_effect);

//! The next of them; none when all are there.
std::optional<ensemble::WavePlan> next_bank_wave(ensemble::Campaign const& campaign, int points_per_effect);

} // namespace demens::gap
