#pragma once

#include "demens/observe/snapshot.hpp"

#include <vector>

namespace demens::report {

//! A run whose pictures, or film, a reader has asked for.
struct ShownRun
{
    int run; //!< its number in the campaign
    std::vector<observe::Snapshot> snapshots;
};

//! What the page shows beside what it always does.
struct Extras
{
    std::vector<ShownRun> pictures; //!< the landmarks of runs
    std::vector<ShownRun> films;    //!< many moments of runs, in order
};

} // namespace demens::report
