#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/storage/journal.hpp"

#include <deque>
#include <map>
#include <optional>

namespace demens::ensemble {

//! Runs of a wave that this process has begun and not ended, several at once, and what its journal tells of
//! them.
class RunsInFlight
{
  public:
    RunsInFlight(Journal& journal, Wave const& wave) : journal_(journal), wave_(wave) {}

    //! \throws FileError
    void start(int row, Journal::Company company, double time);
    //! Gives back when it was started. What came of it is stored by the caller.
    double end(int row);
    //! They are to begin again; gives back their rows. \throws FileError
    std::deque<int> give_up();

    //! From now on signals are noted in the journal for all that are in flight: which of several a crash is
    //! due to is not known, so that their starts stay without an end.
    void note_signals();

  private:
    int run_of(int row) const { return wave_.runs[static_cast<std::size_t>(row)].run; }

    Journal& journal_;
    Wave const& wave_;
    std::map<int, double> started_; //!< by row [s]
    std::optional<CrashNote> note_; //!< none: some have begun or ended since
};

} // namespace demens::ensemble
