#pragma once

#include "demens/base/options.hpp"
#include "demens/shape/region.hpp"

#include <map>
#include <string>

namespace demens::rig::custom {

//! `[[experiment.region]]`
TableSpec region_table();

using Regions = std::map<std::string, shape::Region>;
//! \throws InputError when a region has no volume
Regions read_regions(OptionValues const& experiment);

} // namespace demens::rig::custom
