#pragma once

#include "tao_calib/wave/assessment.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demens::tao_calib {

//! What a campaign does next.
struct NextStep
{
    enum class Kind
    {
        simulate, //!< a wave
        finish,   //!< a stop criterion is met
        give_up   //!< too few runs finished to calibrate anything
    };
    Kind kind = Kind::finish;
    ensemble::WavePurpose purpose = ensemble::WavePurpose::design; //!< of the wave
    std::vector<std::vector<double>> points;                       //!< of the wave, own units
    std::string reason;                                            //!< why it ends
};

//! The first wave of a new campaign: its screening, or else its design.
NextStep first_wave(ensemble::CampaignInput const& input);
//! Decides by the campaign's content and seed alone, never by the number of ranks. `assessment` is the
//! campaign's.
//! \param analysis arrays of the last wave, where they are not stored with it yet
NextStep plan_next_wave(ensemble::Campaign const& campaign, Assessment const& assessment,
                        std::vector<ensemble::NamedArray> const& analysis = {});

//! Whether the waves of the search overlap.
bool waves_overlap(ensemble::CampaignInput const& input);
//! Where waves overlap and the last wave searches: the wave after it, from all runs but those of the last
//! wave, whether they are there or not. None where it depends on them what comes next.
std::optional<NextStep> plan_overlapping_wave(ensemble::Campaign const& campaign,
                                              LeastSquaresSolver const& solver);

} // namespace demens::tao_calib
