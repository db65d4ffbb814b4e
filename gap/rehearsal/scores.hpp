#pragma once

#include "gap/rehearsal/case_answer.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! A case with its truth, and what was said of it.
struct AnsweredCase
{
    CaseTruth truth;
    CaseAnswer answer;
};

//! Which answer came first for which cause: a line a cause, with what came first in how many of its cases.
std::string confusion_text(std::vector<AnsweredCase> const& cases);

//! How good the answers are: right cause first and in its group, false alarms, outsiders flagged or misnamed,
//! pairs, locations, closure, Brier and log scores; shares with 95 % intervals. A single effect is detectable
//! if it stands out of the floor by as much as two effects must that are to be told apart.
std::string score_text(std::vector<AnsweredCase> const& cases);

} // namespace demens::gap
