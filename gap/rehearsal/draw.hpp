#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "gap/catalogue/catalogue.hpp"
#include "gap/rehearsal/truth.hpp"

#include <cstdint>

namespace demens::gap {

//! Effects of a rehearsal.
struct RehearsedEffects
{
    std::vector<CandidateEffect> listed;  //!< those that the diagnosis looks at
    std::vector<CandidateEffect> outside; //!< those that the rigs allow beside them
};
//! Effects that are simulated alone. \throws InputError without any that the campaign lists
RehearsedEffects rehearsed_effects(ensemble::CampaignInput const& input);

//! Draws a case: a quarter none, four in ten a single effect, an eighth two of them, the others one from
//! outside the list (where there is none, nothing); half, all or twice the typical amplitude; factors from
//! the inner eight tenths of their ranges.
CaseTruth draw_case(ensemble::CampaignInput const& input, RehearsedEffects const& effects, std::string name,
                    std::uint64_t seed);

//! A number of the system's entropy.
std::uint64_t entropy();
//! Hexadecimal digits of it.
std::string new_salt();

} // namespace demens::gap
