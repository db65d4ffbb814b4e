#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "gap/catalogue/catalogue.hpp"
#include "gap/rehearsal/truth.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace demens::gap {

//! Effects of a rehearsal.
struct RehearsedEffects
{
    std::vector<CandidateEffect> listed;  //!< those that the diagnosis looks at
    std::vector<CandidateEffect> outside; //!< those that the rigs allow beside them
};
//! An effect to be drawn from outside the list.
struct OutsideEffect
{
    std::string name;
    std::optional<double> typical = {}; //!< amplitude [own unit]; else the catalogue's
};

//! Effects that are simulated alone. \param outside those that are drawn from beside the list; empty: all.
//! \throws InputError without any that the campaign lists, for a name that is not beside the list, and for an
//! amplitude of 0
RehearsedEffects rehearsed_effects(ensemble::CampaignInput const& input,
                                   std::vector<OutsideEffect> const& outside = {});

//! The kind of the next case, so that of all `cases` a quarter have no effect, five of twelve a single one,
//! an eighth two, the others one from outside the list (where there is none, nothing). \param drawn kinds of
//! the cases before it
CaseKind draw_kind(RehearsedEffects const& effects, std::vector<CaseKind> const& drawn, int cases,
                   std::uint64_t seed);

//! Draws a case of a kind: effects at half, all or twice their typical amplitudes; factors from the inner
//! eight tenths of their ranges.
CaseTruth draw_case(ensemble::CampaignInput const& input, RehearsedEffects const& effects, CaseKind kind,
                    std::string name, std::uint64_t seed);

//! A number of the system's entropy.
std::uint64_t entropy();
//! Hexadecimal digits of it.
std::string new_salt();

} // namespace demens::gap
