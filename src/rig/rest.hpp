#pragma once

#include "demens/rig/programme/programme.hpp"

namespace demens::rig {

//! What `rest_s` of a bed says: a stage in which it is left alone between its filling and what is measured,
//! or none.
inline std::vector<Stage> rest_of(OptionValues const& options)
{
    double const time = options.number("rest_s");
    if (time == 0)
        return {};
    return {Stage{.name = "rest", .shortest = time}};
}

} // namespace demens::rig
