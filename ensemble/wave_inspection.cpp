#include "ensemble/wave_inspection.hpp"

#include "ensemble/mpi/agreement.hpp"

#include <cstring>

namespace demens::ensemble {
namespace {

//! Check sums that journals give for the shard of each row of a wave: `first[row]` to `first[row + 1]`.
struct NamedShards
{
    std::vector<int> first = {0}, crcs;

    NamedShards(Wave const& wave, std::map<int, RunHistory> const& histories)
    {
        for (auto const& run : wave.runs) {
            if (auto const found = histories.find(run.run); found != histories.end())
                for (auto const crc : found->second.shard_crcs)
                    crcs.push_back(static_cast<int>(crc));
            first.push_back(static_cast<int>(crcs.size()));
        }
    }
    std::vector<std::uint32_t> of(std::size_t row) const
    {
        return {crcs.begin() + first[row], crcs.begin() + first[row + 1]};
    }
};

//! Where the rows of each rank begin; as many entries as ranks, and one.
std::vector<int> row_limits(std::size_t rows, int ranks)
{
    std::vector<int> limits;
    for (std::size_t rank = 0; rank <= static_cast<std::size_t>(ranks); ++rank)
        limits.push_back(static_cast<int>(rows * rank / static_cast<std::size_t>(ranks)));
    return limits;
}

//! The parts of all ranks, on rank 0.
std::vector<SeenShard> collect(MPI_Comm communicator, std::vector<SeenShard> const& mine,
                               std::vector<int> const& limits)
{
    static_assert(std::is_trivially_copyable_v<SeenShard>);
    std::vector<SeenShard> all(rank_of(communicator) == 0 ? static_cast<std::size_t>(limits.back()) : 0);
    std::vector<int> counts;
    for (std::size_t rank = 0; rank + 1 < limits.size(); ++rank)
        counts.push_back(limits[rank + 1] - limits[rank]);
    MPI_Datatype shard = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(sizeof(SeenShard), MPI_BYTE, &shard);
    MPI_Type_commit(&shard);
    MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), shard, all.data(), counts.data(), limits.data(),
                shard, 0, communicator);
    MPI_Type_free(&shard);
    return all;
}

} // namespace

WaveState inspect(MPI_Comm communicator, Parts const& parts, Wave const& wave, CampaignInput const& input,
                  std::map<int, RunHistory>& histories)
{
    on_root(communicator, [&] { histories = read_journals(parts.folder()); });
    NamedShards named(wave, histories);
    broadcast(communicator, named.first);
    broadcast(communicator, named.crcs);
    auto const limits = row_limits(wave.runs.size(), size_of(communicator));
    auto const rank = static_cast<std::size_t>(rank_of(communicator));
    std::vector<SeenShard> mine;
    on_all(communicator, [&] {
        for (auto row = static_cast<std::size_t>(limits[rank]);
             row < static_cast<std::size_t>(limits[rank + 1]); ++row)
            mine.push_back(parts.look(wave.runs[row], input, named.of(row)));
    });
    auto shards = collect(communicator, mine, limits);
    return rank == 0 ? Parts::state_of(wave, histories, std::move(shards)) : WaveState{};
}

} // namespace demens::ensemble
