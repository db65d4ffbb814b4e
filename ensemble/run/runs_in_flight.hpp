#pragma once

#include "ensemble/run/stop.hpp"
#include "ensemble/storage/journal.hpp"

#include <deque>
#include <map>
#include <optional>

namespace demens::ensemble {

//! Runs that this process has begun and not ended, several at once, and what its journal tells of them.
class RunsInFlight
{
  public:
    explicit RunsInFlight(Journal& journal) : journal_(journal) {}

    //! \param key what it is called here \throws FileError
    void start(int key, int run, Journal::Company company, double time);
    //! Gives back when it was started. What came of it is stored by the caller.
    double end(int key);
    //! They are to begin again; gives back their keys. \throws FileError
    std::deque<int> give_up();

    //! From now on signals are noted in the journal for all that are in flight: which of several a crash is
    //! due to is not known, so that their starts stay without an end.
    void note_signals();

  private:
    struct Started
    {
        int run;
        double time; //!< [s]
    };

    Journal& journal_;
    std::map<int, Started> started_; //!< by key
    std::optional<CrashNote> note_;  //!< none: some have begun or ended since
};

} // namespace demens::ensemble
