#include "demens/base/error.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/schedule.hpp"
#include "ensemble/run/stop.hpp"
#include "ensemble/run/wave_runner.hpp"
#include "ensemble/session.hpp"
#include "ensemble/shared_campaign.hpp"
#include "ensemble/storage/lock.hpp"
#include "ensemble/wave_inspection.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

//! Keeps the rows whose runs belong to the task.
std::vector<int> own_rows(std::vector<int> rows, Wave const& wave, int task, int tasks)
{
    std::erase_if(rows,
                  [&](int row) { return wave.runs[static_cast<std::size_t>(row)].run % tasks != task; });
    return rows;
}

} // namespace

WaveEnd run_shards(MPI_Comm parent, std::filesystem::path const& file, int task, int tasks,
                   SessionOptions const& options)
{
    if (tasks < 1 || task < 0 || task >= tasks)
        throw InputError(fmt::format("task {} of {}: the tasks are numbered from 0 to their number less one",
                                     task, tasks));
    auto const communicator = Communicator::duplicate(parent);
    StopSignals const signals;
    std::unique_ptr<CampaignLock> lock;
    on_root(communicator, [&] { lock = std::make_unique<CampaignLock>(file, CampaignLock::Kind::shards); });
    std::unique_ptr<PresenceMark> presence;
    on_all(communicator, [&] { presence = std::make_unique<PresenceMark>(file); });
    auto const campaign = read_for_all(communicator, file, options.rigs);
    if (!campaign.open_wave())
        return WaveEnd::complete;
    auto const& wave = *campaign.open_wave();
    on_all(communicator, [&] { require_engine(campaign.input.run); });
    Groups const groups(communicator, campaign.input.run.ranks_per_group);
    Parts const parts(file);
    std::unique_ptr<Journal> journal;
    on_root(communicator, [&] { parts.make_folder(); });
    on_all(communicator, [&] {
        if (groups.leads())
            journal =
                std::make_unique<Journal>(parts.folder(), fmt::format("task-{:04}-of-{:04}-rank-{:04}", task,
                                                                      tasks, rank_of(communicator)));
    });

    WaveWork work;
    auto const expected = expected_times(campaign, wave); // the same on all ranks
    work.seconds = expected.seconds;
    work.limits = wall_time_limits(campaign.input.run, expected);
    std::map<int, RunHistory> histories;
    auto const state = inspect(communicator, parts, wave, campaign.input, histories);
    work.pending = longest_first(own_rows(state.pending, wave, task, tasks), work.seconds);
    work.suspicious = longest_first(own_rows(state.suspicious, wave, task, tasks), work.seconds);
    broadcast(communicator, work.pending);
    broadcast(communicator, work.suspicious);
    WaveRunner runner(communicator, groups, campaign.input, parts);
    auto beside_others = work, alone = work;
    beside_others.suspicious.clear();
    alone.pending.clear();
    for (auto const& one : {beside_others, alone})
        if (!one.is_done())
            runner.run({{wave, one}}, journal.get(), options.progress);
    int stopped = StopSignals::request() != StopRequest::none;
    MPI_Allreduce(MPI_IN_PLACE, &stopped, 1, MPI_INT, MPI_MAX, communicator);
    return stopped ? WaveEnd::drained : WaveEnd::complete;
}

} // namespace demens::ensemble
