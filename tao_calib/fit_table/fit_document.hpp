#pragma once

#include "tao_calib/fit_table/targets_met.hpp"

namespace demens::tao_calib {

//! A fit for programs, with all digits and what is not defined left empty (null in JSON); see FIT.md.
std::string fit_json(TableFit const& fit, std::vector<FitOptimum> const& optima,
                     AdmissibleRegion const& region);
//! The same as a table with the columns response, part, item, quantity, value.
std::string fit_csv(TableFit const& fit, std::vector<FitOptimum> const& optima,
                    AdmissibleRegion const& region);

} // namespace demens::tao_calib
