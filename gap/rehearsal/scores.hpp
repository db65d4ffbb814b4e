#pragma once

#include "gap/rehearsal/truth.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! A case with its truth, and what `demens gap --json` said of it.
struct AnsweredCase
{
    CaseTruth truth;
    nlohmann::json answer;
};

//! How good the answers are: right cause first and in its group, false alarms, outsiders flagged or misnamed,
//! pairs, closure, Brier and log scores; shares with 95 % intervals. A case within its first cause that is
//! weaker than half the typical amplitude counts as any other.
std::string score_text(std::vector<AnsweredCase> const& cases);

} // namespace demens::gap
