#pragma once

#include "tao_calib/fit_table/targets_met.hpp"

namespace demens::tao_calib {

//! A fit in plain text: warnings, coefficients and analysis of variance of every response, influence of the
//! factors, optimum and admissible region.
std::string fit_text(TableFit const& fit, std::vector<FitOptimum> const& optima,
                     AdmissibleRegion const& region);

} // namespace demens::tao_calib
