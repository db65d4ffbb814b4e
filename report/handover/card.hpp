#pragma once

#include "ensemble/campaign.hpp"
#include "report/analysis.hpp"
#include "report/handover/counterpart.hpp"

#include <nlohmann/json.hpp>

namespace demens::report {

//! What another program's deck of an experiment was written as, or why it was not.
struct WrittenDeck
{
    std::string experiment;
    Code code;
    std::string file, absent_because; //!< one of them empty
};

//! The material card: values, intervals, evidence, what was fixed, versions, how to replay. HANDOVER.md has
//! its schema. The analysis must have a best run.
nlohmann::json material_card(ensemble::Campaign const& campaign, Analysis const& analysis,
                             contact::Model const& model, std::vector<WrittenDeck> const& decks);

} // namespace demens::report
