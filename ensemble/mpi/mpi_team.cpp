#include "ensemble/mpi/mpi_team.hpp"

#include "ensemble/mpi/agreement.hpp"

#include <algorithm>

namespace demens::ensemble {
namespace {

enum Tag
{
    parcel_tag,
    ghost_tag
};
std::size_t constexpr largest_part = std::size_t{1} << 30; // MPI counts are ints

//! Calls `transfer(data, bytes)` for parts that MPI can count.
template <class Data, class Transfer>
void in_parts(Data* data, std::size_t bytes, Transfer&& transfer)
{
    for (std::size_t at = 0; at < bytes; at += largest_part)
        transfer(data + at, static_cast<int>(std::min(largest_part, bytes - at)));
}

bool is_on_one_machine(MPI_Comm communicator)
{
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    bool const all = size_of(here) == size_of(communicator);
    MPI_Comm_free(&here);
    return all;
}

} // namespace

MpiTeam::MpiTeam(MPI_Comm communicator, Overlap overlap)
    : communicator_(communicator), rank_(rank_of(communicator)), size_(size_of(communicator)),
      overlaps_(overlap == Overlap::always || !is_on_one_machine(communicator))
{
}

//! Not an allreduce, which may add in another order on every rank.
void MpiTeam::sum(std::span<double> values)
{
    if (size_ == 1 || values.empty())
        return;
    auto const count = static_cast<int>(values.size());
    MPI_Reduce(rank_ == 0 ? MPI_IN_PLACE : values.data(), values.data(), count, MPI_DOUBLE, MPI_SUM, 0,
               communicator_);
    MPI_Bcast(values.data(), count, MPI_DOUBLE, 0, communicator_);
}

void MpiTeam::largest(std::span<double> values)
{
    if (size_ > 1)
        MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                      communicator_);
}

std::vector<dem::Team::Parcel> MpiTeam::exchange(std::vector<Parcel> const& out)
{
    std::vector<unsigned long long> sizes_out(static_cast<std::size_t>(size_), 0), sizes_in(sizes_out);
    for (auto const& parcel : out)
        sizes_out[static_cast<std::size_t>(parcel.rank)] = parcel.bytes.size();
    MPI_Alltoall(sizes_out.data(), 1, MPI_UNSIGNED_LONG_LONG, sizes_in.data(), 1, MPI_UNSIGNED_LONG_LONG,
                 communicator_);
    std::vector<Parcel> in;
    std::vector<MPI_Request> requests;
    for (int rank = 0; rank < size_; ++rank)
        if (auto const bytes = sizes_in[static_cast<std::size_t>(rank)]; bytes > 0)
            in.push_back({rank, Bytes(bytes)});
    for (auto& parcel : in)
        in_parts(parcel.bytes.data(), parcel.bytes.size(), [&](std::byte* data, int count) {
            MPI_Irecv(data, count, MPI_BYTE, parcel.rank, parcel_tag, communicator_,
                      &requests.emplace_back());
        });
    for (auto const& parcel : out)
        in_parts(parcel.bytes.data(), parcel.bytes.size(), [&](std::byte const* data, int count) {
            MPI_Isend(data, count, MPI_BYTE, parcel.rank, parcel_tag, communicator_,
                      &requests.emplace_back());
        });
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    return in;
}

std::vector<dem::Team::Bytes> MpiTeam::gather(Bytes const& mine)
{
    std::vector<unsigned long long> sizes(static_cast<std::size_t>(size_));
    unsigned long long const size = mine.size();
    MPI_Allgather(&size, 1, MPI_UNSIGNED_LONG_LONG, sizes.data(), 1, MPI_UNSIGNED_LONG_LONG, communicator_);
    std::vector<Bytes> all(static_cast<std::size_t>(size_));
    for (int rank = 0; rank < size_; ++rank) {
        auto& bytes = all[static_cast<std::size_t>(rank)];
        if (rank == rank_)
            bytes = mine;
        else
            bytes.resize(sizes[static_cast<std::size_t>(rank)]);
        in_parts(bytes.data(), bytes.size(),
                 [&](std::byte* data, int count) { MPI_Bcast(data, count, MPI_BYTE, rank, communicator_); });
    }
    return all;
}

void MpiTeam::begin(std::span<Link const> links, double const* out, double* in)
{
    requests_.clear();
    for (Link const& link : links)
        if (link.in_count > 0)
            MPI_Irecv(in + link.in_begin, static_cast<int>(link.in_count), MPI_DOUBLE, link.rank, ghost_tag,
                      communicator_, &requests_.emplace_back());
    for (Link const& link : links)
        if (link.out_count > 0)
            MPI_Isend(out + link.out_begin, static_cast<int>(link.out_count), MPI_DOUBLE, link.rank,
                      ghost_tag, communicator_, &requests_.emplace_back());
    if (!overlaps_)
        finish();
}

void MpiTeam::finish()
{
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    requests_.clear();
}

} // namespace demens::ensemble
