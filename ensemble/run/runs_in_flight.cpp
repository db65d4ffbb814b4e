#include "ensemble/run/runs_in_flight.hpp"

#include <utility>

namespace demens::ensemble {

void RunsInFlight::start(int row, Journal::Company company, double time)
{
    note_.reset();
    journal_.start(run_of(row), company);
    started_[row] = time;
}

double RunsInFlight::end(int row)
{
    note_.reset();
    return started_.extract(row).mapped();
}

std::deque<int> RunsInFlight::give_up()
{
    note_.reset();
    std::deque<int> rows;
    for (auto const& [row, time] : std::exchange(started_, {})) {
        journal_.drain(run_of(row));
        rows.push_back(row);
    }
    return rows;
}

void RunsInFlight::note_signals()
{
    if (note_)
        return;
    std::string stop_lines;
    for (auto const& [row, time] : started_)
        stop_lines += journal_.stop_line(run_of(row));
    note_.emplace(journal_.descriptor(), stop_lines, [&](int signal) {
        return started_.size() == 1 ? journal_.crash_line(run_of(started_.begin()->first), signal)
                                    : std::string();
    });
}

} // namespace demens::ensemble
