#include "ensemble/run/runs_in_flight.hpp"

#include <utility>

namespace demens::ensemble {

void RunsInFlight::start(int key, int run, Journal::Company company, double time)
{
    note_.reset();
    journal_.start(run, company);
    started_[key] = {run, time};
}

double RunsInFlight::end(int key)
{
    note_.reset();
    return started_.extract(key).mapped().time;
}

std::deque<int> RunsInFlight::give_up()
{
    note_.reset();
    std::deque<int> keys;
    for (auto const& [key, one] : std::exchange(started_, {})) {
        journal_.drain(one.run);
        keys.push_back(key);
    }
    return keys;
}

void RunsInFlight::note_signals()
{
    if (note_)
        return;
    std::string stop_lines;
    for (auto const& [key, one] : started_)
        stop_lines += journal_.stop_line(one.run);
    note_.emplace(journal_.descriptor(), stop_lines, [&](int signal) {
        return started_.size() == 1 ? journal_.crash_line(started_.begin()->second.run, signal)
                                    : std::string();
    });
}

} // namespace demens::ensemble
