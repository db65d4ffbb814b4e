#pragma once

#include "ensemble/mpi/announcements.hpp"
#include "ensemble/mpi/shared_counters.hpp"
#include "ensemble/run/wave_work.hpp"

#include <deque>
#include <optional>

namespace demens::ensemble {

//! A run in a WorkQueue: its place in the order in which runs begin.
using Place = int;

//! The pending runs of waves, one wave after the other. Whoever leads a group takes the next one when the
//! group is free. Rank 0 can add waves while the others simulate. Construction, finish() and destruction are
//! collective over all ranks that have a group.
class WorkQueue
{
  public:
    //! \param waves the same on all ranks; at least one
    //! \param grows whether rank 0 may add more
    WorkQueue(MPI_Comm communicator, CampaignInput const& input, std::deque<QueuedWave> waves, bool grows);

    //! The next run that no group has; none: not now, or never, which is_over() tells.
    std::optional<Place> take();
    //! After take() gave none: whether there is nothing to take later either.
    bool is_over();
    //! Nobody takes any more.
    void close();
    //! A run is over.
    void count(Place place, bool has_failed);
    //! Lets MPI answer others; called now and then by a rank that computes for long.
    void progress();

    //! Number of waves that this rank knows: those that were there at first, and what take() and receive()
    //! have brought.
    int known() const { return static_cast<int>(waves_.size()); }
    //! Takes in the next wave, of which the first rank of this rank's group knows.
    void receive();
    QueuedWave const& wave(int number) const { return waves_[static_cast<std::size_t>(number)]; }
    QueuedWave const& wave_of(Place place) const { return wave(wave_number(place)); }
    int row_of(Place place) const;
    RunRecord const& plan_of(Place place) const;

    //! \name Of rank 0
    //! The first wave that is not settled; known() when all are.
    int front() const { return front_; }
    //! Whether all runs of that wave that were pending are over.
    bool is_front_done();
    //! The wave at the front needs nothing more. \param next what is added; none: no wave follows
    void settle(std::optional<QueuedWave> next);
    //! Pending runs of a wave, not settled, that are over; those of them that failed; expected seconds.
    struct Done
    {
        int runs, failed;
        double seconds;
    };
    Done done(int wave);

    //! When nobody takes any more: who does not know the last waves receives them.
    void finish();

  private:
    bool is_closed();
    int wave_number(Place place) const;
    void append(QueuedWave wave);
    void announce(QueuedWave const& wave);

    MPI_Comm communicator_;
    CampaignInput const& input_;
    SharedCounters counters_;
    Announcements announcements_;
    std::deque<QueuedWave> waves_;
    std::vector<Place> ends_;      //!< one past the last run, by wave
    std::optional<Place> claimed_; //!< nobody else takes it; maybe of a wave to come
    int front_ = 0;
};

} // namespace demens::ensemble
