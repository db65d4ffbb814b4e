#pragma once

#include "ensemble/campaign.hpp"

#include <string>
#include <vector>

namespace demens::ensemble {

//! What a deviation from a target is told in.
enum class Yardstick
{
    tolerance, //!< where every target has one
    scale
};

//! How far responses are from all targets, without units.
struct FitQuality
{
    double root_mean_square = 0; //!< of (response - target)/scale
    double largest = 0;          //!< largest deviation from a target, in its tolerance or scale
    std::string worst = {};      //!< `experiment.response` that is so far off
    Yardstick yardstick = Yardstick::scale;
    int targets = 0;
};
//! \param responses of all targets, in their order
FitQuality fit_quality(CampaignInput const& input, std::vector<double> const& responses);
//! In one sentence without an end, e.g. `within 0.6 tolerances of all targets`.
std::string headline(FitQuality const& quality);

//! Whether the targets can be met together, by the last analysis of a wave; empty before anything is fitted.
std::string targets_text(Wave const& wave);
//! Factor by which the noise of the intervals was enlarged; 1: not.
double noise_inflation(Wave const& wave);

} // namespace demens::ensemble
