#pragma once

#include <vector>

namespace demens::gap {

//! Which of these p values are rejected at a false discovery rate `rate` (Benjamini and Hochberg, J. R. Stat.
//! Soc. B 57:289, 1995).
std::vector<bool> reject_by_rate(std::vector<double> const& p_values, double rate);

} // namespace demens::gap
