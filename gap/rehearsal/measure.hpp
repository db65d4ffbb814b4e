#pragma once

#include "ensemble/session.hpp"
#include "gap/rehearsal/draw.hpp"

#include <filesystem>
#include <mpi.h>
#include <string>

namespace demens::gap {

//! What is measured in a case.
struct MeasuredCase
{
    enum class End
    {
        measured,
        stopped,     //!< as asked; it goes on where it was
        unmeasurable //!< no run of one of the experiments has finished
    };
    End end;
    //! On rank 0: the campaign's text with the measured values, or the experiment that cannot be measured.
    std::string text;
};

//! Simulates what would be measured in a case, in a campaign file of its own, which it goes on with where it
//! is there. Collective. \throws InputError for targets that are curves or pictures
MeasuredCase measured_campaign(MPI_Comm communicator, ensemble::CampaignInput const& input,
                               RehearsedEffects const& effects, CaseTruth const& truth,
                               std::filesystem::path const& file, int repeats);

} // namespace demens::gap
