#pragma once

#include "demens/rig/rig.hpp"

#include <string>

namespace demens::ensemble::input {

//! What is wrong with a file, one line each: the fault that ended its reading, then those of other keys, in
//! the order of the file, so that an author mends all of them at once.
std::string with_all_faults(std::string const& first, std::string const& toml, std::string const& origin,
                            std::vector<rig::RigInfo> const& rigs);

} // namespace demens::ensemble::input
