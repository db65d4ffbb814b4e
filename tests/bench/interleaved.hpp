#pragma once

#include "demens/dem/simulation.hpp"

#include <memory>
#include <string>
#include <vector>

namespace demens::bench {

//! Time on the processor since the start of the program [s]: others on the machine do not count.
double processor_seconds();

//! A simulation that is timed in turns with others, so that what disturbs the machine disturbs all of them.
struct Contestant
{
    std::string name;
    std::unique_ptr<dem::Simulation> simulation;
    std::vector<double> seconds = {}; //!< of a step, in each round
    double contacts = 0;              //!< in a step of the last round
    double rebuilds = 0;              //!< per step, of all rounds

    double best() const;
    double nanoseconds_per_contact() const { return 1e9 * best() / contacts; }
    double million_particle_steps() const
    {
        return 1e-6 * static_cast<double>(simulation->counts().particles) / best();
    }
};

//! Every contestant takes `steps` steps in each round, after as many as `warm_up` before the first.
void time_in_turns(std::vector<Contestant>& contestants, int warm_up, int steps, int rounds);

//! Time of one over that of another in all rounds together: with many short rounds what disturbs the machine
//! disturbs both alike, and rebuilds count as often as they happen.
double total_ratio(Contestant const& one, Contestant const& other);
//! Median over the rounds of the time of one over that of another in the same round.
double median_ratio(Contestant const& one, Contestant const& other);

} // namespace demens::bench
