#include "tests/bench/interleaved.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>

namespace demens::bench {

double processor_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Contestant::best() const
{
    return *std::min_element(seconds.begin(), seconds.end());
}

void time_in_turns(std::vector<Contestant>& contestants, int warm_up, int steps, int rounds)
{
    for (Contestant& c : contestants)
        c.simulation->advance(warm_up);
    for (int round = 0; round < rounds; ++round)
        for (Contestant& c : contestants) {
            auto const rebuilds = c.simulation->counts().rebuilds;
            double const start = processor_seconds();
            c.simulation->advance(steps);
            c.seconds.push_back((processor_seconds() - start) / steps);
            c.contacts =
                static_cast<double>(c.simulation->counts().contacts + c.simulation->counts().wall_contacts);
            c.rebuilds += static_cast<double>(c.simulation->counts().rebuilds - rebuilds) / (steps * rounds);
        }
}

double total_ratio(Contestant const& one, Contestant const& other)
{
    return std::accumulate(one.seconds.begin(), one.seconds.end(), 0.0) /
           std::accumulate(other.seconds.begin(), other.seconds.end(), 0.0);
}

double median_ratio(Contestant const& one, Contestant const& other)
{
    std::vector<double> ratios;
    for (std::size_t k = 0; k < one.seconds.size(); ++k)
        ratios.push_back(one.seconds[k] / other.seconds[k]);
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

} // namespace demens::bench
