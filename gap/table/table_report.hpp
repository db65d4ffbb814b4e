#pragma once

#include "gap/table/table_gap.hpp"

#include <nlohmann/json_fwd.hpp>

namespace demens::gap {

//! Where a table of runs and measurements contradict each other, in one screen.
std::string table_gap_text(MeasuredTable const& measured, TableGap const& gap);
//! The same with all digits; what is not defined is null.
nlohmann::ordered_json table_gap_document(MeasuredTable const& measured, TableGap const& gap);

} // namespace demens::gap
