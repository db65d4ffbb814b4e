#pragma once

#include "ensemble/campaign.hpp"

#include <map>
#include <vector>

namespace demens::ensemble {

//! Wall times that the runs of a wave may take, and how far such predictions were off so far.
struct ExpectedTimes
{
    std::vector<double> seconds; //!< by row of the wave
    double scatter = 0;          //!< standard deviation of finished runs over their prediction
    int finished = 0;            //!< runs that this rests on; 0: a guess
};

//! Predicted costs times the rates that finished runs show, those of the same experiment where there are any.
//! \param measured wall times [s] of runs of this wave that have finished, by run number
ExpectedTimes expected_times(Campaign const& campaign, Wave const& wave,
                             std::map<int, double> const& measured = {});

//! Wall times [s] after which runs of the wave are given up, by row; 0: none. Where the campaign does not
//! say, it is generous: a run that never ends must not hold a campaign up, and a slow machine must not end a
//! good run.
std::vector<double> wall_time_limits(RunOptions const& options, ExpectedTimes const& expected);

//! Rows of a wave, longest expected run first, in the order of the numbers where equal.
std::vector<int> longest_first(std::vector<int> rows, std::vector<double> const& seconds);

//! What it takes so many groups to do runs one after the other [s]: each takes the next one when it is free.
double time_to_run(std::vector<double> const& seconds, int groups);

} // namespace demens::ensemble
