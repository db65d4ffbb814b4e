#pragma once

#include "demens/dem/device_batch.hpp"
#include "demens/rig/programme/programme_run.hpp"

#include <memory>
#include <vector>

namespace demens::rig {

class Crew;

//! Runs that go on together: the steps of all between two looks are done at once by the device of a batch,
//! and their looks beside each other on the cores of this process. A run that is over makes room for another
//! while the rest goes on. None of that changes what a run gives.
class RunBatch
{
  public:
    //! \param threads that look at the runs
    //! \param wall_time_limit of each run, from its beginning on [s]; 0: none
    RunBatch(dem::DeviceBatch& device, int threads, double wall_time_limit);
    ~RunBatch();

    bool has_room() const { return runs_.size() < device_.slots(); }
    bool is_empty() const { return runs_.empty(); }
    //! \param key whatever tells it from others; there must be room
    void begin(int key, Programme programme);

    struct Ended
    {
        int key;
        RunResult result;
        double wall_time; //!< its share, by particles and steps, of the time that the batch took [s]
    };
    //! Advances all to the next look of some; gives those that are over. \throws std::bad_alloc, DeviceError:
    //! then all runs are lost
    std::vector<Ended> advance();
    double seconds_of_looks() const { return seconds_of_looks_; } //!< in which the device did nothing

  private:
    struct Member;

    void prepare();
    std::vector<Ended> take_ended();

    dem::DeviceBatch& device_;
    std::unique_ptr<Crew> crew_; //!< who looks
    double wall_time_limit_;
    double seconds_of_looks_ = 0;
    std::vector<std::unique_ptr<Member>> runs_;
};

//! Cores that this process may use.
int usable_cores();

} // namespace demens::rig
