#include "ensemble/run/together.hpp"

#include "demens/rig/programme/programme.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <algorithm>

namespace demens::ensemble {
namespace {

//! Most particles of a run of these rows.
double most_particles(CampaignInput const& input, Wave const& wave, std::vector<int> const& rows)
{
    double most = 1;
    for (int const row : rows) {
        auto const& plan = wave.runs[static_cast<std::size_t>(row)];
        auto const& rig = *input.experiments[static_cast<std::size_t>(plan.experiment)].rig;
        try {
            if (rig.describe)
                most = std::max(most, rig.describe(run_input_of(input, plan)).expected_particles);
        } catch (std::exception const&) { // the run will say what is wrong
        }
    }
    return most;
}

std::optional<dem::EngineKind> kind_of_device(rig::EngineChoice choice)
{
    switch (choice) {
    case rig::EngineChoice::cpu:
        return {};
    case rig::EngineChoice::cuda_on_host:
        return dem::EngineKind::cuda_on_host;
    case rig::EngineChoice::cuda:
    case rig::EngineChoice::automatic:
        break;
    }
    return dem::is_present(dem::EngineKind::cuda) ? std::optional(dem::EngineKind::cuda) : std::nullopt;
}

//! Simulations for which there is memory.
std::uint32_t room_of(dem::EngineKind kind, int device, double particles)
{
    try {
        return dem::simulations_that_fit(kind, device, particles);
    } catch (dem::DeviceError const&) {
        return 1; // who begins one will say what is wrong
    }
}

} // namespace

std::optional<DeviceShare> device_share(MPI_Comm communicator, CampaignInput const& input, Wave const& wave,
                                        std::vector<int> const& rows)
{
    auto const node = Communicator::of_node(communicator);
    int const here = rank_of(node), ranks_here = size_of(node), ranks = size_of(communicator);
    auto const kind = kind_of_device(input.run.engine);
    if (!kind || input.run.ranks_per_group > 1)
        return {};
    int const devices = *kind == dem::EngineKind::cuda ? dem::device_count() : 1;
    DeviceShare share{*kind, here % devices, static_cast<std::uint32_t>(input.run.runs_together),
                      std::max(1, rig::usable_cores() / ranks_here)};
    if (share.runs == 0) {
        auto const sharers = static_cast<std::uint32_t>((ranks_here + devices - 1) / devices);
        auto const fit = room_of(*kind, share.device, most_particles(input, wave, rows));
        auto const wanted = (static_cast<int>(rows.size()) + ranks - 1) / ranks;
        share.runs =
            std::clamp<std::uint32_t>(static_cast<std::uint32_t>(wanted), 1, std::max(1u, fit / sharers));
    }
    return share;
}

RunsTogether::RunsTogether(CampaignInput const& input, DeviceShare const& share)
    : input_(input), device_(share.kind, share.device, share.runs),
      batch_(device_, share.threads, std::max(0.0, input.run.run_wall_time_s))
{
}

std::vector<int> RunsTogether::keys() const
{
    std::vector<int> keys;
    for (auto const& [key, plan] : plans_)
        keys.push_back(key);
    return keys;
}

void RunsTogether::begin(int key, RunRecord const& plan)
{
    plans_[key] = plan;
    auto const& rig = *input_.experiments.at(static_cast<std::size_t>(plan.experiment)).rig;
    rig::RunResult result;
    try {
        auto const run_input = run_input_of(input_, plan);
        if (rig.describe)
            return batch_.begin(key, rig::programme_of(rig, run_input, 1));
        result = rig.run(run_input, {}); // one that is not described has no part on a device
    } catch (std::exception const& error) {
        result.status = rig::RunStatus::error;
        result.reason = error.what();
    }
    end(key, std::move(result), 0);
}

void RunsTogether::end(int key, rig::RunResult result, double wall_time)
{
    ended_.push_back({key, finished_run(input_, plans_.at(key), std::move(result), wall_time)});
    plans_.erase(key);
}

std::vector<RunsTogether::Ended> RunsTogether::advance()
{
    if (!batch_.is_empty())
        for (auto& one : batch_.advance())
            end(one.key, std::move(one.result), one.wall_time);
    return std::exchange(ended_, {});
}

} // namespace demens::ensemble
