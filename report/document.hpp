#pragma once

#include "ensemble/campaign.hpp"
#include "report/extras.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace demens::report {

//! Snapshots and series of a finished run, wherever they come from. \throws InputError when there are none.
using DetailsOf = std::function<ensemble::RunDetails(int run)>;

//! Everything that the page shows, as one JSON document; report/page/main.js lists its members.
nlohmann::json document_of(ensemble::Campaign const& campaign, DetailsOf const& details_of,
                           Extras const& extras = {});

} // namespace demens::report
