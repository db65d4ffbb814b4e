#pragma once

#include <string>
#include <string_view>

namespace demens::ensemble {

//! The unit that the name of a column carries: `t_s`, `mass [g]`, `torque (mN m)`, `v / mm/s`, `flow_kg_s`;
//! empty: none.
std::string unit_in_name(std::string const& column);

//! How many of `to` one of `from` is, e.g. 1e-3 for g and kg. Small letters and capitals count the same, and
//! `kg_s` the same as `kg/s`. \throws InputError, without a place, when they measure different things or are
//! not known
double unit_ratio(std::string_view from, std::string_view to);

} // namespace demens::ensemble
