#pragma once

#include "demens/rig/programme/run_batch.hpp"
#include "ensemble/run/execute.hpp"

#include <map>
#include <mpi.h>
#include <optional>

namespace demens::ensemble {

//! What a group has of a device.
struct DeviceShare
{
    dem::EngineKind kind;
    int device;         //!< number among those that its process sees
    std::uint32_t runs; //!< at once
    int threads;        //!< that look at them
};

//! What this rank computes the runs of a wave on; none: on processors, one after another. Groups of one rank
//! take the devices of their node in turns. Collective.
std::optional<DeviceShare> device_share(MPI_Comm communicator, CampaignInput const& input, Wave const& wave,
                                        std::vector<int> const& rows);

//! Runs that one device does at once. Whatever goes wrong in one is its status and reason.
class RunsTogether
{
  public:
    RunsTogether(CampaignInput const& input, DeviceShare const& share);

    bool has_room() const { return plans_.size() < device_.slots(); }
    //! Keys of those that are not over.
    std::vector<int> keys() const;
    //! \param key what it is called here
    void begin(int key, RunRecord const& plan);
    //! Whether none goes on, and none is over that has not been given yet.
    bool is_empty() const { return plans_.empty() && ended_.empty(); }

    struct Ended
    {
        int key;
        FinishedRun run;
    };
    //! Goes on with all for a moment. \throws std::bad_alloc, dem::DeviceError: then all are to begin again
    std::vector<Ended> advance();

  private:
    void end(int key, rig::RunResult result, double wall_time);

    CampaignInput const& input_;
    dem::DeviceBatch device_;
    rig::RunBatch batch_;
    std::map<int, RunRecord> plans_; //!< by key, of those that are not over
    std::vector<Ended> ended_;
};

} // namespace demens::ensemble
