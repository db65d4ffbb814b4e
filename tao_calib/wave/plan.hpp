#pragma once

#include "tao_calib/wave/assessment.hpp"

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

} // namespace demens::tao_calib
