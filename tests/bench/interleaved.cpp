#include "tests/bench/interleaved.hpp"

#include <algorithm>
#include <chrono>

namespace demens::bench {

double Contestant::best() const
{
    return *std::min_element(seconds.begin(), seconds.end());
}

void time_in_turns(std::vector<Contestant>& contestants, int warm_up, int steps, int rounds)
{
    for (Contestant& c : contestants)
        c.simulation->steps(warm_up);
    for (int round = 0; round < rounds; ++round)
        for (Contestant& c : contestants) {
            auto const rebuilds = c.simulation->rebuilds();
            auto const start = std::chrono::steady_clock::now();
            c.simulation->steps(steps);
            double const taken =
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            c.seconds.push_back(taken / steps);
            c.contacts =
                static_cast<double>(c.simulation->particle_contacts() + c.simulation->wall_contacts());
            c.rebuilds += static_cast<double>(c.simulation->rebuilds() - rebuilds) / (steps * rounds);
        }
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
