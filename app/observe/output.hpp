#pragma once

#include "app/observe/sources.hpp"

namespace demens::cli {

//! What is printed of observations, in the format that is asked for. \throws InputError where targets are
//! asked for and there is no scatter
std::string output_of(Observations const& observations, ObserveArguments const& arguments);

//! Writes masks, profiles and overlays into a folder. \return how many files
int write_pictures(Observations const& observations, ObserveArguments const& arguments);

} // namespace demens::cli
