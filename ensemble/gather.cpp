#include "ensemble/gather.hpp"

#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <fmt/format.h>
#include <memory>

namespace demens::ensemble {
namespace {

//! Rows of this rank: contiguous, in the order of the ranks.
struct Rows
{
    std::vector<RunRecord> runs;
    std::vector<RunDetails> details;
    unsigned long long bytes = 0; //!< of the shards
};

Rows load_rows(MPI_Comm communicator, CampaignInput const& input, Parts const& parts,
               FinishedWave const& finished)
{
    auto const total = finished.wave.runs.size();
    auto const rank = static_cast<std::size_t>(rank_of(communicator));
    auto const size = static_cast<std::size_t>(size_of(communicator));
    Rows rows;
    for (std::size_t row = total * rank / size; row < total * (rank + 1) / size; ++row) {
        auto run = parts.load(finished.wave.runs[row], input, {finished.crcs.at(row)});
        rows.runs.push_back(std::move(run.record));
        rows.details.push_back(std::move(run.details));
        rows.bytes += parts.shard_size(finished.wave.runs[row]);
    }
    return rows;
}

//! Of results bit for bit; the sum over any split of the runs is the same.
unsigned long long check_sum(std::vector<RunRecord> const& runs)
{
    unsigned long long sum = 0;
    for (auto const& run : runs) {
        std::vector<double> numbers = run.responses;
        numbers.insert(numbers.end(), {static_cast<double>(run.run), static_cast<double>(run.status),
                                       run.wall_time, run.simulated_time, static_cast<double>(run.steps)});
        sum += crc32_of(std::as_bytes(std::span(numbers)));
    }
    return sum;
}

//! Rank 0 makes the datasets; then each rank writes its rows into the closed file.
void write_together(MPI_Comm communicator, std::filesystem::path const& copy, CampaignInput const& input,
                    Wave const& wave, Rows const& rows)
{
    hdf5::File file; // on rank 0
    on_root(communicator, [&] { file = hdf5::open_to_write(copy); });
    RowWriter writer(file, communicator);
    auto mine = wave;
    mine.runs = rows.runs;
    write_results(writer, mine, input);
    write_details(writer, wave.number, rows.runs, rows.details, input);
    auto const pieces = writer.pieces();
    on_root(communicator, [&] { file.close(); });
    on_all(communicator, [&] { write_pieces(copy, pieces); });
}

} // namespace

void gather(MPI_Comm communicator, std::filesystem::path const& file, CampaignInput const& input,
            Parts const& parts, FinishedWave const& finished)
{
    Rows rows;
    on_all(communicator, [&] { rows = load_rows(communicator, input, parts, finished); });
    unsigned long long sums[2] = {rows.bytes, check_sum(rows.runs)};
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);

    std::unique_ptr<FileUpdate> update; // on rank 0
    auto const copy = beside(file, ".new");
    on_root(communicator,
            [&] { update = std::make_unique<FileUpdate>(file, sums[0] + (std::uintmax_t{4} << 20)); });
    write_together(communicator, copy, input, finished.wave, rows);
    on_root(communicator, [&] {
        update->verify();
        auto const stored = read_wave(hdf5::open_to_read(copy), finished.wave.number, input);
        if (!is_complete(stored) || check_sum(stored.runs) != sums[1])
            throw FileError(fmt::format(
                "{}: what was read back is not what was written; the disk may be failing", copy.string()));
        update->commit();
    });
}

} // namespace demens::ensemble
