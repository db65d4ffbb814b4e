#pragma once

#include "ensemble/campaign.hpp"

#include <vector>

namespace demens::ensemble {

//! What a wave is to be run with; the same on all ranks.
struct WaveWork
{
    std::vector<int> pending;    //!< rows, in the order in which they begin
    std::vector<int> suspicious; //!< rows to run one at a time, with nothing beside them
    std::vector<double> seconds; //!< expected wall time of every row of the wave
    std::vector<double> limits;  //!< [s] wall time after which its run is given up; 0: none
    double clock = 0;            //!< [s] working time of the wave so far
    int done = 0, failed = 0;    //!< runs of the wave that are complete

    bool is_done() const { return pending.empty() && suspicious.empty(); }
};

//! A wave that is being run.
struct QueuedWave
{
    Wave wave;
    WaveWork work;
};

} // namespace demens::ensemble
