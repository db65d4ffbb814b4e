#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace demens::ensemble {

//! How far a wave is.
struct ProgressState
{
    int runs = 0, done = 0, failed = 0; //!< failed ones are among the done
    double work = 0, work_done = 0;     //!< [expected seconds on one group] of the runs of this session
    int groups = 1;
    double elapsed = 0; //!< [s] in this session
};

//! Wall time left [s]; NaN when nothing is known yet.
double seconds_left(ProgressState const& state);
//! `4 s`, `3 min 20 s`, `2 h 05 min`; `unknown` for NaN.
std::string duration_text(double seconds);

//! Shows how a wave goes on, where the log level is `info` or below: a line that is rewritten on a terminal,
//! a plain line now and then in a log and between the lines of single runs (`debug`).
class ProgressDisplay
{
  public:
    //! No stream: silent.
    ProgressDisplay(std::FILE* stream, std::string label);

    //! Shows the state, not more often than is useful.
    void update(ProgressState const& state);
    //! Shows it and ends the line.
    void finish(ProgressState const& state);

  private:
    using Clock = std::chrono::steady_clock;

    void show(ProgressState const& state, char const* before, char const* after) const;

    std::FILE* stream_;
    bool on_terminal_;
    std::string label_;
    Clock::time_point next_;
};

} // namespace demens::ensemble
