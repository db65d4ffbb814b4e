#pragma once

#include "demens/rig/programme/programme.hpp"

namespace demens::rig {

//! Numbers of a model that no material has, as they come of a wrong unit; one line each.
std::vector<std::string> unit_warnings(contact::Model const& model);
//! Lengths of what stands there at first that no experiment on a bench has.
std::vector<std::string> unit_warnings(Apparatus const& apparatus);

} // namespace demens::rig
